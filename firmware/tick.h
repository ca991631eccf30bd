// SPDX-License-Identifier: MIT
// The millisecond, by alarm 0 of the timer (data sheet 4.6): the measurement, then, at a time that
// does not depend on its sampling points, the rules and what they set. Interrupts stay masked: an
// alarm only ends the sleep of the main loop.
//
// Its phase follows the host's set-points, each of which otherwise waited up to a millisecond and
// then for the work: now it waits for `kWaitUs`, give or take what the host is late or early by.
#pragma once

#include "firmware/registers.h"

namespace hedgehog::firmware {

class Tick {
 public:
  void start() noexcept {
    reg(kTimer + 0x38) = 1;
    set_next(now_us() + kPeriodUs);
  }

  /// True once the measurement of the next millisecond is due. Call it, then `take`, until each is
  /// true; what was missed is made up for at once.
  bool take_measurement() noexcept {
    if (!is_past(next_us_ - kMeasureUs)) return false;
    set_alarm(next_us_);
    return true;
  }

  /// True once a millisecond: its rules are due.
  bool take() noexcept {
    if (!is_past(next_us_)) return false;
    began_us_ = next_us_;
    if (ticks_since_join_ < kJoinEvery) ++ticks_since_join_;
    set_next(next_us_ + kPeriodUs);
    return true;
  }

  /// A set-point that had arrived at `arrived_us` was taken in this millisecond.
  /// Moves the start of the next millisecond towards `kWaitUs` after that arrival: by at most 5 us,
  /// or, when it is later by more than `kFarUs`, by at most 500 us, once in `kJoinEvery` ticks.
  /// Call it at most once a millisecond. No millisecond becomes longer by more than 5 us, because a
  /// boost lasts one, and because the arrival may have been noticed only after the measurement.
  void follow(uint32_t arrived_us) noexcept {
    const int32_t late_us =
        static_cast<int32_t>(began_us_ - arrived_us) - static_cast<int32_t>(kWaitUs);
    int32_t step_us = late_us / kShare;
    int32_t max_step_us = kMaxStepUs;
    if (late_us > kFarUs && ticks_since_join_ == kJoinEvery) {
      ticks_since_join_ = 0;
      step_us = late_us;
      max_step_us = kMaxJoinUs;
    }
    if (step_us > max_step_us) step_us = max_step_us;
    if (step_us < -kMaxStepUs) step_us = -kMaxStepUs;
    set_next(next_us_ - static_cast<uint32_t>(step_us));
  }

 private:
  static constexpr uint32_t kPeriodUs = 1000;
  /// The sampling points of the windings, wherever the PWM's periods begin: `Converter::measure`.
  static constexpr uint32_t kMeasureUs = 200;
  /// With work of at most 230 us after it, about as much is left before as behind.
  static constexpr uint32_t kWaitUs = 370;
  static constexpr int32_t kShare = 8;
  static constexpr int32_t kMaxStepUs = 5;
  /// A host is early by less, relative to the mean phase that the tick follows.
  static constexpr int32_t kFarUs = 250;
  /// Work that takes longer than the shortened millisecond delays the next one, which makes up.
  static constexpr int32_t kMaxJoinUs = 500;
  static constexpr uint32_t kJoinEvery = 100;

  static bool is_past(uint32_t us) noexcept { return static_cast<int32_t>(now_us() - us) >= 0; }

  void set_next(uint32_t us) noexcept {
    next_us_ = us;
    set_alarm(next_us_ - kMeasureUs);
  }

  static void set_alarm(uint32_t us) noexcept {
    reg(kTimer + 0x34) = 1;
    reg(kTimer + 0x10) = us;
  }

  uint32_t began_us_ = 0;
  uint32_t next_us_ = 0;
  uint32_t ticks_since_join_ = kJoinEvery;
};

}  // namespace hedgehog::firmware
