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

/// The current at which the thesis states its force (Fig. 2.9).
inline constexpr double kBurstCurrentA = 15.0;

struct Electromagnet {
  std::string_view name;
  /// A m^2 per ampere.
  double moment_per_ampere = 0.0;
};

/// By the thesis' simulation, 0.4 N at 15 A on the thesis' pin at offset 0: 0.202271 A m^2/A.
Electromagnet fea_electromagnet() noexcept;
/// By the thesis' measurement, 0.0126 N/A on the typical pin of its ball at rest (section 3.1.1):
/// 0.1004 A m^2/A. Computes `thesis_ball()` on first use.
Electromagnet measured_electromagnet();

/// Outward force per A m^2 on a pin to which the dipole points, N.
double force_per_moment_n(const CylinderMagnet& pin, double sphere_radius_mm,
                          double offset_mm) noexcept;

/// Outward force on a pin, N: `angle_deg` between the field and the pin's axis.
double coil_force_n(const Electromagnet& coil, double current_a, const CylinderMagnet& pin,
                    double sphere_radius_mm, double angle_deg, double offset_mm) noexcept;

/// Relative force on a pin while the field is aimed at another one.
struct Activation {
  int id = 0;
  double angle_deg = 0.0;
  /// Relative to the force on the aimed pin, all at offset 0; negative: pulled in.
  double fraction = 0.0;
};

/// All pins by descending fraction, the aimed one first. REQUIRES: `aimed` is the id of a pin of
/// `arrangement`.
std::vector<Activation> activation_spread(const Arrangement& arrangement, int aimed);

}  // namespace hedgehog::model
