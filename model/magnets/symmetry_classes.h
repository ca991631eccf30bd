// SPDX-License-Identifier: MIT
// Pins with equal angles to all other magnets have the same force curve (thesis Fig. 2.10). Derived
// from the angles alone, so that the symmetry of arrays with magnets removed need not be known.
// Design time and start-up: allocates.
#pragma once

#include <vector>

#include "model/magnets/arrangement.h"

namespace hedgehog::model {

/// Angles equal within this are merged into their mean.
inline constexpr double kSameAngleDeg = 2e-4;

struct AngleCount {
  double angle_deg = 0.0;
  int count = 0;
};

struct PinClass {
  /// Ids of the pins, ascending.
  std::vector<int> pins;
  /// From each of these pins to all other pins, and to all shields; ascending.
  std::vector<AngleCount> to_pins;
  std::vector<AngleCount> to_shields;
};

/// Every pin is in exactly one class. The classes are ordered by the nearest shield, nearest first
/// (tkD: the 12 pentagons, the 60 hexagons beside one, the 20 between three). tkD: 2 ms. Keep the
/// value: it holds for all sizes.
std::vector<PinClass> symmetry_classes(const Arrangement& arrangement);

}  // namespace hedgehog::model
