// SPDX-License-Identifier: MIT
// Real-time pacing of the race.
#pragma once

#include <chrono>
#include <thread>

#include "clients/racer/game/race.h"

namespace hedgehog::racer {

/// One thread. Late steps do not cause a burst: a delay beyond a tenth of a second is not caught
/// up.
class Pace {
 public:
  /// `speed` times real time.
  explicit Pace(double speed)
      : step_(std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double>(Race::kStepS / speed))) {}

  using Clock = std::chrono::steady_clock;

  /// Due time of the next step. Call it once per step.
  Clock::time_point next() {
    due_ += step_;
    const Clock::time_point now = Clock::now();
    if (now - due_ > kLate) due_ = now;
    return due_;
  }
  /// Waits until then.
  void wait() { std::this_thread::sleep_until(next()); }

 private:
  static constexpr std::chrono::milliseconds kLate{100};
  Clock::duration step_;
  Clock::time_point due_ = Clock::now();
};

}  // namespace hedgehog::racer
