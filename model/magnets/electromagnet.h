// SPDX-License-Identifier: MIT
// The electromagnet as designers of arrays see it: a dipole in the centre that pushes a pin of any
// size at any offset (reference: physics.md section 5). The law itself is model/calibration.h's.
// Pure; any thread.
#pragma once

#include <string_view>
#include <vector>

#include "model/calibration.h"
#include "model/magnets/arrangement.h"
#include "model/magnets/pair/cylinder_magnet.h"

namespace hedgehog::model {

/// The current at which the thesis states its force (Fig. 2.9), and the one it calls indefinite.
inline constexpr double kBurstCurrentA = 15.0;

struct Electromagnet {
  std::string_view name;
  /// A m^2 per ampere.
  double moment_per_ampere = 0.0;
};

/// The thesis' simulation, 0.4 N at 15 A on the thesis' pin at offset 0: 0.202271 A m^2/A.
Electromagnet fea_electromagnet() noexcept;
/// Its measurement, 0.0126 N/A on the typical pin of the thesis' ball at its rest, where it was
/// measured (section 3.1.1): 0.1004 A m^2/A. Computes `thesis_ball()` when that is not there yet.
Electromagnet measured_electromagnet();

/// Outward force per A m^2 on a pin that the dipole points at, N.
double force_per_moment_n(const CylinderMagnet& pin, double sphere_radius_mm,
                          double offset_mm) noexcept;

/// Outward force on a pin, N: `angle_deg` between the field and the pin's axis.
double coil_force_n(const Electromagnet& coil, double current_a, const CylinderMagnet& pin,
                    double sphere_radius_mm, double angle_deg, double offset_mm) noexcept;

/// What the other pins get while one is aimed at.
struct Activation {
  int id = 0;
  double angle_deg = 0.0;
  /// Of the force on the aimed pin, all at offset 0; negative: pulled in.
  double fraction = 0.0;
};

/// Every pin, the aimed one first, then falling. REQUIRES: `aimed` is the id of a pin there.
std::vector<Activation> activation_spread(const Arrangement& arrangement, int aimed);

}  // namespace hedgehog::model
