// SPDX-License-Identifier: MIT
// Fault debouncing by a leaky integrator: the held time grows while the condition is true and falls
// while it is false.
#pragma once

#include <algorithm>

namespace hedgehog::control {

/// Real-time safe, trivially copyable.
class FaultDebounce {
 public:
  /// `dt_s` later. True when `wrong` has held for `hold_s` (more when it came and went). However
  /// long the step, it takes three of them.
  constexpr bool step(bool wrong, double dt_s, double hold_s) noexcept {
    const double counted_s = std::min(dt_s, hold_s / 3.0);
    held_s_ = wrong ? std::min(held_s_ + counted_s, hold_s) : std::max(0.0, held_s_ - counted_s);
    return held_s_ > 0.0 && held_s_ >= hold_s - 0.5 * counted_s;
  }
  /// Something was wrong lately.
  constexpr bool pending() const noexcept { return held_s_ > 0.0; }
  constexpr void reset() noexcept { held_s_ = 0.0; }

 private:
  double held_s_ = 0.0;
};

}  // namespace hedgehog::control
