// SPDX-License-Identifier: MIT
// Figures for a comparison of balls, besides forces.
#pragma once

#include "clients/design/casing/casing.h"
#include "clients/design/input/design.h"

namespace hedgehog::design {

/// The thesis' electromagnet: 590 g of copper, 110 g of iron (reference: physics.md section 7). Its
/// radius of 35 mm (thesis section 2.3) is a lower bound for the sphere of the magnets.
inline constexpr double kElectromagnetMassG = 700.0;
inline constexpr double kElectromagnetRadiusMm = 35.0;

/// Magnets, electromagnet, and the casing as solid PLA, although it is usually printed partly
/// hollow.
struct BallMass {
  double parts_g = 0.0;
  double casing_g = 0.0;

  double total_g() const noexcept { return parts_g + casing_g; }
};

/// For the ball of the thesis 1.18 kg of parts, compared with 1.2 kg for the complete ball, and 0.3
/// kg of plastic if that were solid.
inline BallMass mass_of(const model::Arrangement& arrangement, const Design& design) {
  return {kElectromagnetMassG + model::magnets_mass_g(arrangement, design.sizes()),
          kPlasticGMm3 * volume_mm3(casing_of(design, arrangement))};
}

inline double outer_diameter_mm(const Design& design) noexcept {
  return 2.0 * outer_radius_mm(design.sphere_mm, design.magnet, design.shield);
}

}  // namespace hedgehog::design
