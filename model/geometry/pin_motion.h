// SPDX-License-Identifier: MIT
// The live twin: what the electromagnet does to every pin of a ball, as a force and as a way.
#pragma once

#include <vector>

#include "model/coils.h"
#include "model/geometry/pin_array.h"
#include "model/magnets/pin_curves.h"

namespace hedgehog::model {

/// Of each pin, by its number.
struct PinMotion {
  /// What the coils push with, N, outwards positive, on the pin at its rest
  /// (`PinCurves::force_at_rest_n`). What the shields hold against it is not in it.
  std::vector<double> force_n;
  /// How far that holds the pin from where it rests without current, mm, outwards positive
  /// (`PinCurves::extension_mm`). The pin has settled: neither its mass nor a hand on it counts.
  std::vector<double> extension_mm;
  friend bool operator==(const PinMotion&, const PinMotion&) = default;
};

/// `slope_n_a`: see `force_on_pin`. Allocates: for any thread but the control loop. REQUIRES:
/// array.pins.size() == curves.size(), both of the same ball.
PinMotion pin_motion(const PinArray& array, const PinCurves& curves, const FieldDemand& field,
                     double slope_n_a);

}  // namespace hedgehog::model
