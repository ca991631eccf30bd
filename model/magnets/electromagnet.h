// SPDX-License-Identifier: MIT
// The electromagnet in array design: a dipole in the centre that pushes a pin of any size at any
// offset (reference: physics.md section 5). Force law: model/calibration.h. Pure; any thread.
#pragma once

#include <string_view>
#include <vector>

#include "model/calibration.h"
#include "model/magnets/arrangement.h"
#include "model/magnets/pair/cylinder_magnet.h"

namespace hedgehog::model {

inline constexpr double kBurstCurrentA = 15.0;  // of the thesis' force (Fig. 2.9)

struct Electromagnet {
  std::string_view name;
  double moment_per_ampere = 0.0;  // A m^2 / A
};

/// By `kFeaCalibration`: 0.202271 A m^2/A.
Electromagnet fea_electromagnet() noexcept;
/// By `kMeasuredCalibration`: 0.1004 A m^2/A. Computes `thesis_ball()` on first use.
Electromagnet measured_electromagnet();

/// Outward force per A m^2 on a pin to which the dipole points.
double force_per_moment_n(const CylinderMagnet& pin, double sphere_radius_mm,
                          double offset_mm) noexcept;

/// Outward force on a pin; `angle_deg` is between the field and the pin's axis.
double coil_force_n(const Electromagnet& coil, double current_a, const CylinderMagnet& pin,
                    double sphere_radius_mm, double angle_deg, double offset_mm) noexcept;

struct Activation {
  int id = 0;
  double angle_deg = 0.0;
  double fraction = 0.0;  // of the force on the aimed pin, all at offset 0; negative: pulled in
};

/// All pins by descending fraction, the aimed one first. REQUIRES: `arrangement` has `aimed`.
std::vector<Activation> activation_spread(const Arrangement& arrangement, int aimed);

}  // namespace hedgehog::model
