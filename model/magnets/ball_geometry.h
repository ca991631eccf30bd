// SPDX-License-Identifier: MIT
// Magnets of a ball as in its device file, and derived from that: its pins by number, and the
// displacement of each by a force. Start-up only: allocates.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/geometry/pin_array.h"
#include "model/magnets/magnet_array.h"
#include "model/magnets/pin_curves.h"

namespace hedgehog::model {

struct BallGeometry {
  std::string arrangement = "tkD-86";  // as for `arrangement_named`
  std::vector<int> removed_pins{};     // ids in that arrangement
  std::vector<int> removed_shields{};
  int front_pin = 1;  // id there; its meridian is the front (the arrow on the casing)
  ArraySizes sizes{};

  friend bool operator==(const BallGeometry&, const BallGeometry&) = default;
};

/// Front at +x, pins renumbered by `number_sites`. An error names a missing pin (to remove, or the
/// front) or the magnets that overlap.
MagnetResult<Arrangement> arrangement_of(const BallGeometry& geometry);

struct BallPins {
  PinArray array;
  PinCurves curves;  // in the order of `array`
};

/// Computed in every call (at most 0.7 s), but the ball of the thesis only once (80 ms).
MagnetResult<std::shared_ptr<const BallPins>> ball_pins(const BallGeometry& geometry);

/// The ball of the thesis (section 2.3): tkD without the bottom pentagon and its five hexagons,
/// where the fan is. 86 pins, 0..85 in rings of 1, 5, 10, 15, 15, 15, 15 and 10; front: pin 1.
const BallPins& thesis_ball();

}  // namespace hedgehog::model
