// SPDX-License-Identifier: MIT
// Grace period at start-up: no clients until the ball is armed or the period is over.
#pragma once

#include <chrono>
#include <cstdint>

namespace hedgehog::daemon {

/// Prevents that the first client connects before the ball is armed at start-up.
class StartupGrace {
 public:
  using Clock = std::chrono::steady_clock;

  explicit StartupGrace(Clock::time_point begun) noexcept : begun_(begun) {}
  /// `ticks`: executed by control. Over after half a second of both the clock and control, or after
  /// five seconds on a machine on which control hardly runs.
  bool over(Clock::time_point now, std::uint64_t ticks) const noexcept {
    const auto since = now - begun_;
    return since > kLongest || (since > kUsual && ticks > kTicks);
  }

 private:
  static constexpr std::uint64_t kTicks = 500;
  static constexpr std::chrono::milliseconds kUsual{500};
  static constexpr std::chrono::milliseconds kLongest{5000};

  Clock::time_point begun_;
};

}  // namespace hedgehog::daemon
