// SPDX-License-Identifier: MIT
// What a person compares balls by, besides forces.
#pragma once

#include "clients/design/casing/casing.h"
#include "clients/design/input/design.h"

namespace hedgehog::design {

/// The thesis' electromagnet as its parts weigh: 590 g of copper, 110 g of iron (reference:
/// physics.md section 7). It has a radius of 35 mm (thesis section 2.3); magnets cannot be nearer.
inline constexpr double kElectromagnetMassG = 700.0;
inline constexpr double kElectromagnetRadiusMm = 35.0;

/// Magnets and electromagnet, before any plastic: 1.18 kg for the ball of the thesis, which says
/// 1.2 kg with everything.
inline double mass_g(const model::Arrangement& arrangement, const model::ArraySizes& sizes) {
  return kElectromagnetMassG + model::magnets_mass_g(arrangement, sizes);
}

inline double outer_diameter_mm(const Design& design) noexcept {
  return 2.0 * outer_radius_mm(design.sphere_mm, design.magnet, design.shield);
}

}  // namespace hedgehog::design
