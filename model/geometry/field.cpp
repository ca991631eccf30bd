// SPDX-License-Identifier: MIT
#include "model/geometry/field.h"

namespace hedgehog::model {

void pin_forces(const PinArray& array, const FieldDemand& field, double slope_n_a,
                std::span<double> forces_n) noexcept {
  for (std::size_t i = 0; i < array.pins.size(); ++i)
    forces_n[i] = force_on_pin(field, array.pins[i].position, slope_n_a);
}

FieldSpread spread_of(const PinArray& array, const FieldDemand& field, double slope_n_a,
                      double threshold_n) noexcept {
  FieldSpread spread;
  const double full_n = slope_n_a * norm(field.a);
  if (!(full_n > 0.0)) return spread;
  for (const Pin& pin : array.pins) {
    const double force_n = force_on_pin(field, pin.position, slope_n_a);
    if (force_n >= 0.9 * full_n) ++spread.pins_90;
    if (force_n >= 0.5 * full_n) ++spread.pins_50;
    if (force_n < 0.0) ++spread.pins_inward;
    if (force_n > threshold_n) ++spread.pins_above;
  }
  return spread;
}

}  // namespace hedgehog::model
