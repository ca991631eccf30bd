// SPDX-License-Identifier: MIT
// Which magnets a ball has and where, as its device file says it, and what follows from that: its
// pins by number, and how far a force moves each. Start-up only: allocates.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/geometry/pin_array.h"
#include "model/magnets/magnet_array.h"
#include "model/magnets/pin_curves.h"

namespace hedgehog::model {

struct BallGeometry {
  /// As `arrangement_named` knows them.
  std::string arrangement = "tkD-86";
  /// Numbers of that arrangement, whose pins and shields are not there.
  std::vector<int> removed_pins{};
  std::vector<int> removed_shields{};
  /// The pin of that arrangement on whose meridian the arrow on the casing is: the front.
  int front_pin = 1;
  ArraySizes sizes{};

  friend bool operator==(const BallGeometry&, const BallGeometry&) = default;
};

/// The magnets of a ball, the front at +x. Pins are numbered anew, ring by ring from the top, in
/// each ring anticlockwise from the front. An error names what there is not (a pin to remove, the
/// front), or which magnets overlap.
MagnetResult<Arrangement> arrangement_of(const BallGeometry& geometry);

struct BallPins {
  PinArray array;
  /// In the order of `array`.
  PinCurves curves;
};

/// Computed by every call, but for the ball of the thesis, whose are computed once (80 ms). Each
/// angle between two magnets is computed once: GP(8,0) less two pins, the largest array without any
/// symmetry, takes 0.4 s for its places and 0.3 s for its curves.
MagnetResult<std::shared_ptr<const BallPins>> ball_pins(const BallGeometry& geometry);

/// The ball of the thesis (section 2.3): the tkD array, the canonical GP(3,0) of 92 faces with a
/// pentagon on top, less the pentagon at the bottom and its five hexagons, where the fan is. 86
/// pins, 0..85 in rings of 1, 5, 10, 15, 15, 15, 15 and 10. The front is the meridian of pin 1, of
/// ring 1.
const BallPins& thesis_ball();

}  // namespace hedgehog::model
