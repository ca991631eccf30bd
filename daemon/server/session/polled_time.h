// SPDX-License-Identifier: MIT
// Elapsed time without the time in which this process was suspended or delayed.
#pragma once

#include <algorithm>
#include <chrono>

namespace hedgehog::server {

/// Time measured by a loop that polls every few milliseconds: each poll adds at most `kMaxStep`.
/// One thread.
class PolledTime {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kMaxStep{50};

  explicit PolledTime(Clock::time_point now) noexcept : last_(now) {}

  void poll(Clock::time_point now) noexcept {
    elapsed_ += std::min<Clock::duration>(now - last_, kMaxStep);
    last_ = now;
  }
  /// Resets the elapsed time to zero.
  void restart(Clock::time_point now) noexcept { *this = PolledTime(now); }
  /// As of the last poll.
  Clock::duration elapsed() const noexcept { return elapsed_; }

 private:
  Clock::time_point last_;
  Clock::duration elapsed_{0};
};

}  // namespace hedgehog::server
