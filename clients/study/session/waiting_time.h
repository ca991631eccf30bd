// SPDX-License-Identifier: MIT
// How long an unattended run waits for its ball.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>

namespace hedgehog::study {

/// Pure: callers pass the time. For a ball that cools down its own time counts, as long as it
/// passes: that of a simulated ball may pass more slowly than the clock's.
class WaitingTime {
 public:
  using Clock = std::chrono::steady_clock;
  /// For a daemon or a ball.
  static constexpr std::chrono::seconds kTimeout{120};
  /// For a ball to cool down. In a room of 20 °C it cools from its limit to 40 °C in a third of
  /// that.
  static constexpr std::chrono::minutes kCooling{30};

  explicit WaitingTime(Clock::time_point now) : since_(now) {}

  bool is_over(Clock::time_point now) const { return now - since_ > kTimeout; }
  /// For a ball that becomes ready by cooling down, at `ball_ns` of its time.
  bool is_over_cooling(Clock::time_point now, std::int64_t ball_ns) {
    if (ball_ns != ball_ns_) since_ = now;
    ball_ns_ = ball_ns;
    // It may be less after a restart of the daemon.
    cooling_since_ns_ = std::min(cooling_since_ns_, ball_ns);
    return is_over(now) || std::chrono::nanoseconds(ball_ns - cooling_since_ns_) > kCooling;
  }

 private:
  Clock::time_point since_;
  std::int64_t ball_ns_ = -1;
  std::int64_t cooling_since_ns_ = std::numeric_limits<std::int64_t>::max();
};

}  // namespace hedgehog::study
