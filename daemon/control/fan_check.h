// SPDX-License-Identifier: MIT
// Does the fan turn when it is told to? No tachometer pulse for 3 s is a fault (DESIGN section 6).
#pragma once

#include "daemon/control/debounce.h"
#include "daemon/control/state.h"

namespace hedgehog::control {

/// Control thread; real-time safe, trivially copyable.
class FanCheck {
 public:
  static constexpr double kHoldS = 3.0;
  /// Slower than this is standing: a 7200 rpm fan idles far above.
  static constexpr double kLeastRpm = 300.0;

  /// `dt_s` later, with the duty that was commanded (0..1) and the tachometer of fresh telemetry.
  Reason step(double commanded_duty, double rpm, double dt_s) noexcept {
    const bool standing = commanded_duty > 0.0 && !(rpm >= kLeastRpm);
    if (!standing) standing_.reset();  // one turn shows that it is not seized
    due_ = standing_.step(standing, dt_s, kHoldS);
    return due_ ? Reason::kFanStopped : Reason::kNone;
  }
  void reset() noexcept {
    standing_.reset();
    due_ = false;
  }
  /// It is told to turn, and did not in the last tick.
  bool standing() const noexcept { return standing_.suspicious(); }
  /// It stands, and has for 3 s.
  bool stopped() const noexcept { return due_; }

 private:
  Debounce standing_;
  bool due_ = false;
};

}  // namespace hedgehog::control
