// SPDX-License-Identifier: MIT
// The ball unrolled like a world map, for a terminal: front in the middle, left on the left, back
// at both edges, up on top. One line a ring of pins.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::client {

/// Forces from which a pin is drawn as felt, clear, strong; newton. 0.026 N is what people just
/// feel (thesis section 3.3: 2.1 A).
inline constexpr double kFeltN = 0.026;
inline constexpr double kClearN = 0.05;
inline constexpr double kStrongN = 0.1;

struct BallMapStyle {
  /// `. o O @` instead of `· ∘ ○ ●`.
  bool ascii = false;
  /// Marks the pin nearest to this direction (device frame) with a triangle: where up is in the
  /// room.
  std::optional<model::Vec3> room_up;
};

/// Ten lines of at most 78 columns: "up", eight rings, "left front right". `force_n` has the
/// outward force on each pin by its number (negative: pulled in).
std::vector<std::string> ball_map(std::span<const double> force_n, const BallMapStyle& style);

/// "· rest   ∘ felt   ○ clear   ● strong".
std::string ball_map_legend(bool ascii);

}  // namespace hedgehog::client
