// SPDX-License-Identifier: MIT
// Pins with equal angles to all other magnets have the same force curve (thesis Fig. 2.10), also
// where magnets are removed. Design time and start-up: allocates.
#pragma once

#include <vector>

#include "model/magnets/arrangement.h"

namespace hedgehog::model {

inline constexpr double kSameAngleDeg = 2e-4;  // closer angles are merged into their mean

struct AngleCount {
  double angle_deg = 0.0;
  int count = 0;
};

struct PinClass {
  std::vector<int> pins;               // ids, ascending
  std::vector<AngleCount> to_pins;     // from each of them to all other pins, ascending
  std::vector<AngleCount> to_shields;  // to all shields, ascending
};

/// Every pin is in one class; order: nearest shield first (tkD: the 12 pentagons, the 60 hexagons
/// beside one, the 20 between three). tkD: 2 ms. Keep the value: it holds for all sizes.
std::vector<PinClass> symmetry_classes(const Arrangement& arrangement);

}  // namespace hedgehog::model
