// SPDX-License-Identifier: MIT
// The ball unrolled like a world map, for a terminal: front in the middle, left on the left, back
// at both edges, up at the top. One line per ring of pins.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/geometry/pin_array.h"
#include "model/vec3.h"

namespace hedgehog::client {

/// Forces from which a pin is drawn as felt, clear, strong; newton. 0.026 N is the perception
/// threshold (thesis section 3.3: 2.1 A).
inline constexpr double kFeltN = 0.026;
inline constexpr double kClearN = 0.05;
inline constexpr double kStrongN = 0.1;

struct BallMapStyle {
  /// `. o O @` instead of `· ∘ ○ ●`.
  bool ascii = false;
  /// Marks the pin nearest to this direction (device frame), the world's up, with a triangle.
  std::optional<model::Vec3> world_up{};
  /// Numbers only: strong pins bold; dim those below the perception threshold or pulled in.
  bool colour = false;
};

/// Ten lines of at most 78 columns: "up", eight rings (several per line for a ball with more),
/// "left front right". `force_n`: the outward force on each pin by its number (negative: pulled
/// in).
std::vector<std::string> ball_map(const model::PinArray& pins, std::span<const double> force_n,
                                  const BallMapStyle& style);

/// The same ten lines, wider (79 columns), with the extension of each pin from its rest in
/// hundredths of a millimetre: `24` is 0.24 mm, `-9` is 0.09 mm further in, a dot is less than
/// 0.005 mm.
std::vector<std::string> ball_numbers(const model::PinArray& pins,
                                      std::span<const double> extension_mm,
                                      std::span<const double> force_n, const BallMapStyle& style);

/// "· rest   ∘ felt   ○ clear   ● strong".
std::string ball_map_legend(bool ascii);

}  // namespace hedgehog::client
