// SPDX-License-Identifier: MIT
// Fault debouncing by a leaky integrator: the held time grows while the condition is true and falls
// while it is false.
#pragma once

#include <algorithm>

namespace hedgehog::control {

/// Real-time safe, trivially copyable.
class FaultDebounce {
 public:
  /// Advances by `dt_s`. True when `wrong` has held for `hold_s`, or longer if intermittent. Takes
  /// at least three steps, however long they are.
  constexpr bool step(bool wrong, double dt_s, double hold_s) noexcept {
    const double counted_s = std::min(dt_s, hold_s / 3.0);
    held_s_ = wrong ? std::min(held_s_ + counted_s, hold_s) : std::max(0.0, held_s_ - counted_s);
    return held_s_ > 0.0 && held_s_ >= hold_s - 0.5 * counted_s;
  }
  /// The condition held recently.
  constexpr bool pending() const noexcept { return held_s_ > 0.0; }
  constexpr void reset() noexcept { held_s_ = 0.0; }

 private:
  double held_s_ = 0.0;
};

}  // namespace hedgehog::control
