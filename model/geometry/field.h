// SPDX-License-Identifier: MIT
// Forces of a field on the pins. The electromagnet acts as a dipole in the centre, so the force on
// a pin along its radius is slope * |field| * cos(angle between them), exactly (reference:
// physics.md section 5): pins in the hemisphere towards the field are pushed out, the others pulled
// in.
#pragma once

#include <span>

#include "model/coils.h"
#include "model/geometry/pin_array.h"
#include "model/vec3.h"

namespace hedgehog::model {

/// Force on the pin at `pin_direction` (unit vector), N, outwards positive. `slope_n_a`: force per
/// ampere on the typical pin at its rest position with the field along it, as
/// kMeasuredCalibration.force_slope_n_a; the force on other pins at their rest positions differs by
/// up to 5 % (`PinCurves::force_at_rest_n`). RT-safe.
constexpr double force_on_pin(const FieldDemand& field, const Vec3& pin_direction,
                              double slope_n_a) noexcept {
  return slope_n_a * dot(field.a, pin_direction);
}

/// The force on every pin, N. REQUIRES: forces_n.size() >= array.pins.size(). RT-safe.
void pin_forces(const PinArray& array, const FieldDemand& field, double slope_n_a,
                std::span<double> forces_n) noexcept;

}  // namespace hedgehog::model
