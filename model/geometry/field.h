// SPDX-License-Identifier: MIT
// Forces of a field on the pins, by a dipole in the centre: along a pin's radius exactly slope *
// |field| * cos(angle between them), pushed out or pulled in (reference: physics.md section 5).
#pragma once

#include <span>

#include "model/coils.h"
#include "model/geometry/pin_array.h"
#include "model/vec3.h"

namespace hedgehog::model {

/// N, outwards positive. `slope_n_a`: on the typical pin at rest with the field along it; the force
/// on other pins at rest differs by up to 5 % (`PinCurves::force_at_rest_n`). RT-safe.
constexpr double force_on_pin(const FieldDemand& field, const Vec3& pin_direction,
                              double slope_n_a) noexcept {
  return slope_n_a * dot(field.a, pin_direction);
}

/// REQUIRES: forces_n.size() >= array.pins.size(). RT-safe.
void pin_forces(const PinArray& array, const FieldDemand& field, double slope_n_a,
                std::span<double> forces_n) noexcept;

}  // namespace hedgehog::model
