// SPDX-License-Identifier: MIT
// Steps of the race in real time.
#pragma once

#include <chrono>
#include <thread>

#include "clients/racer/game/race.h"

namespace hedgehog::racer {

/// One thread. A step that came late is not followed by a burst: time lost beyond a tenth of a
/// second stays lost.
class Pace {
 public:
  /// `speed` times real time.
  explicit Pace(double speed)
      : step_(std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double>(Race::kStepS / speed))) {}

  using Clock = std::chrono::steady_clock;

  /// When the next step is due. To be called once a step.
  Clock::time_point next() {
    due_ += step_;
    const Clock::time_point now = Clock::now();
    if (now - due_ > kLate) due_ = now;
    return due_;
  }
  /// Until then.
  void wait() { std::this_thread::sleep_until(next()); }

 private:
  static constexpr std::chrono::milliseconds kLate{100};
  Clock::duration step_;
  Clock::time_point due_ = Clock::now();
};

}  // namespace hedgehog::racer
