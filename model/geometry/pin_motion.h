// SPDX-License-Identifier: MIT
// Force and displacement of every pin of a ball by the electromagnet, for the live twin.
#pragma once

#include <vector>

#include "model/coils.h"
#include "model/geometry/pin_array.h"
#include "model/magnets/pin_curves.h"

namespace hedgehog::model {

/// By pin number, outwards positive: `PinCurves::force_at_rest_n` of the coil, without the shields'
/// counterforce, and the static `PinCurves::extension_mm`, without the pin's mass or a hand on it.
struct PinMotion {
  std::vector<double> force_n;
  std::vector<double> extension_mm;
  friend bool operator==(const PinMotion&, const PinMotion&) = default;
};

/// `slope_n_a`: see `force_on_pin`. Allocates: not for the control thread. REQUIRES: one ball's
/// array and curves.
PinMotion pin_motion(const PinArray& array, const PinCurves& curves, const FieldDemand& field,
                     double slope_n_a);

}  // namespace hedgehog::model
