// SPDX-License-Identifier: MIT
// Force and displacement of every pin of a ball by the electromagnet, for the live twin.
#pragma once

#include <vector>

#include "model/coils.h"
#include "model/geometry/pin_array.h"
#include "model/magnets/pin_curves.h"

namespace hedgehog::model {

/// Indexed by pin number.
struct PinMotion {
  /// Coil force, N, outwards positive, on the pin at its rest position
  /// (`PinCurves::force_at_rest_n`). Without the counterforce of the shields.
  std::vector<double> force_n;
  /// Static displacement by that force from the rest position, mm, outwards positive
  /// (`PinCurves::extension_mm`). Without the pin's mass and without a hand on it.
  std::vector<double> extension_mm;
  friend bool operator==(const PinMotion&, const PinMotion&) = default;
};

/// `slope_n_a`: see `force_on_pin`. Allocates: any thread except the control thread. REQUIRES:
/// array.pins.size() == curves.size(), both of the same ball.
PinMotion pin_motion(const PinArray& array, const PinCurves& curves, const FieldDemand& field,
                     double slope_n_a);

}  // namespace hedgehog::model
