// SPDX-License-Identifier: MIT
// Magnets of a ball and their positions, as in its device file, and derived from that: its pins by
// number, and the displacement of each by a force. Start-up only: allocates.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/geometry/pin_array.h"
#include "model/magnets/magnet_array.h"
#include "model/magnets/pin_curves.h"

namespace hedgehog::model {

struct BallGeometry {
  /// A name accepted by `arrangement_named`.
  std::string arrangement = "tkD-86";
  /// Ids of pins and shields of that arrangement that are removed.
  std::vector<int> removed_pins{};
  std::vector<int> removed_shields{};
  /// The pin of that arrangement whose meridian is the front (the arrow on the casing).
  int front_pin = 1;
  ArraySizes sizes{};

  friend bool operator==(const BallGeometry&, const BallGeometry&) = default;
};

/// The magnets of a ball, front at +x. Pins are renumbered ring by ring from the top, in each ring
/// anticlockwise from the front. An error names a missing pin (to remove, or the front) or the
/// magnets that overlap.
MagnetResult<Arrangement> arrangement_of(const BallGeometry& geometry);

struct BallPins {
  PinArray array;
  /// In the order of `array`.
  PinCurves curves;
};

/// Computed in every call, except for the ball of the thesis, which is computed once (80 ms). Each
/// angle between two magnets is computed once: GP(8,0) without two pins, the largest array without
/// symmetry, takes 0.4 s for its positions and 0.3 s for its curves.
MagnetResult<std::shared_ptr<const BallPins>> ball_pins(const BallGeometry& geometry);

/// The ball of the thesis (section 2.3): the tkD array, the canonical GP(3,0) of 92 faces with a
/// pentagon on top, without the pentagon at the bottom and its five hexagons, where the fan is. 86
/// pins, 0..85 in rings of 1, 5, 10, 15, 15, 15, 15 and 10. The front is the meridian of pin 1
/// (ring 1).
const BallPins& thesis_ball();

}  // namespace hedgehog::model
