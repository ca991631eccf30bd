// SPDX-License-Identifier: MIT
#include "model/geometry/field.h"

namespace hedgehog::model {

void pin_forces(const PinArray& array, const FieldDemand& field, double slope_n_a,
                std::span<double> forces_n) noexcept {
  for (std::size_t i = 0; i < array.pins.size(); ++i)
    forces_n[i] = force_on_pin(field, array.pins[i].position, slope_n_a);
}

}  // namespace hedgehog::model
