// SPDX-License-Identifier: MIT
// Elapsed time without the time in which this process itself was held up.
#pragma once

#include <algorithm>
#include <chrono>

namespace hedgehog::server {

/// Time as a loop sees it that polls every few milliseconds: each poll counts at most `kMaxStep`.
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
  /// Elapsed time is zero again.
  void restart(Clock::time_point now) noexcept { *this = PolledTime(now); }
  /// As of the last poll.
  Clock::duration elapsed() const noexcept { return elapsed_; }

 private:
  Clock::time_point last_;
  Clock::duration elapsed_{0};
};

}  // namespace hedgehog::server
