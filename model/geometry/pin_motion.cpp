// SPDX-License-Identifier: MIT
#include "model/geometry/pin_motion.h"

#include "model/geometry/field.h"

namespace hedgehog::model {

PinMotion pin_motion(const PinArray& array, const PinCurves& curves, const FieldDemand& field,
                     double slope_n_a) {
  PinMotion motion{std::vector<double>(curves.size()), std::vector<double>(curves.size())};
  pin_forces(array, field, slope_n_a, motion.force_n);
  curves.extensions_mm(motion.force_n, motion.extension_mm);
  for (std::size_t pin = 0; pin < curves.size(); ++pin)
    motion.force_n[pin] = curves.force_at_rest_n(pin, motion.force_n[pin]);
  return motion;
}

}  // namespace hedgehog::model
