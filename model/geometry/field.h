// SPDX-License-Identifier: MIT
// What a field does to the pins. The electromagnet acts as a dipole in the centre, so the force on
// a pin along its radius is slope * |field| * cos(angle between them), exactly (reference:
// physics.md section 5): pins of the whole half towards the field are pushed out, the others are
// pulled in.
#pragma once

#include <span>

#include "model/coils.h"
#include "model/geometry/pin_array.h"
#include "model/vec3.h"

namespace hedgehog::model {

/// Force on the pin at `pin_direction` (unit vector), N, outwards positive. `slope_n_a`: force per
/// ampere on a pin that the field aims at, e.g. kMeasuredCalibration.force_slope_n_a. RT-safe.
constexpr double force_on_pin(const FieldDemand& field, const Vec3& pin_direction,
                              double slope_n_a) noexcept {
  return slope_n_a * dot(field.a, pin_direction);
}

/// The ampere-equivalents that push a pin with `force_n` when aimed at it. REQUIRES: slope_n_a > 0.
constexpr double current_for_force(double force_n, double slope_n_a) noexcept {
  return force_n / slope_n_a;
}

/// The force on every pin, N. REQUIRES: forces_n.size() >= array.pins.size(). RT-safe.
void pin_forces(const PinArray& array, const FieldDemand& field, double slope_n_a,
                std::span<double> forces_n) noexcept;

/// How widely a field is felt: never one pin, always an area (thesis section 3.1.3).
struct FieldSpread {
  /// Pins with at least 90 % and 50 % of the force that a pin exactly in the field's way gets.
  int pins_90 = 0;
  int pins_50 = 0;
  /// Pins that are pulled in.
  int pins_inward = 0;
  /// Pins pushed with more than the threshold asked for.
  int pins_above = 0;
};

/// `threshold_n`: what counts as felt, 0.03 N in thesis section 3.1.3. A field of zero has no
/// spread at all. RT-safe.
FieldSpread spread_of(const PinArray& array, const FieldDemand& field, double slope_n_a,
                      double threshold_n) noexcept;

}  // namespace hedgehog::model
