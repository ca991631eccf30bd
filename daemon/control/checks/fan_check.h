// SPDX-License-Identifier: MIT
// Fan supervision. Fault: no tachometer pulse for 3 s while driven (daemon/safety.md). Cooling is
// credited only by fresh telemetry of a fan that is driven and turns within its range.
#pragma once

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/state/state.h"

namespace hedgehog::control {

/// One tick of what is known of the fan. Made and used on the control thread.
struct FanReading {
  /// New in this tick; otherwise duty and speed are ignored.
  bool fresh = false;
  /// As the board applies it, 0..1.
  double duty = 0.0;
  /// Its tachometer, 1/min.
  double rpm = 0.0;
};

/// Control thread; real-time safe, trivially copyable.
class FanCheck {
 public:
  static constexpr double kHoldS = 3.0;
  /// Slower than this is standing: a 7200 rpm fan idles far above.
  static constexpr double kMinRpm = 300.0;
  /// Shares of the full speed between which the tachometer is credited with cooling. A fan at 0.7
  /// cools a fifth less, as much as the thermal constants may be off; one at 1.5 does not exist.
  static constexpr double kMinCoolingShare = 0.7;
  static constexpr double kMaxCoolingShare = 1.5;
  static constexpr double kMinCoolingDuty = 0.9;
  /// The tachometer must have shown it for so long, and telemetry may be this old.
  static constexpr double kCoolingHoldS = 0.5;
  static constexpr double kMaxAgeS = 0.1;
  /// A driven fan that has not been credited for so long does not work.
  static constexpr double kMaxStartS = 10.0;

  FanCheck() noexcept = default;
  explicit FanCheck(double full_rpm) noexcept : full_rpm_(full_rpm) {}

  /// `dt_s` later, with the duty that was commanded (0..1) and the tachometer of fresh telemetry.
  Reason step(double commanded_duty, double rpm, double dt_s) noexcept {
    const bool standing = commanded_duty > 0.0 && !(rpm >= kMinRpm);
    if (!standing) standing_.reset();  // one turn shows that it is not seized
    due_ = standing_.step(standing, dt_s, kHoldS);
    return due_ ? Reason::kFanStopped : Reason::kNone;
  }
  /// `dt_s` later, in every tick.
  void follow(const FanReading& reading, double dt_s) noexcept;
  void reset() noexcept {
    standing_.reset();
    due_ = false;
  }
  /// It is driven, and did not turn in the last tick.
  bool standing() const noexcept { return standing_.pending(); }
  /// It has not turned for 3 s.
  bool stopped() const noexcept { return due_; }
  /// It counts as cooling the core.
  bool cooling() const noexcept { return cooling_s_ >= kCoolingHoldS; }
  /// False once it is driven and does not count as cooling; true again when it does.
  bool works() const noexcept { return works_; }

 private:
  double full_rpm_ = 7200.0;
  FaultDebounce standing_;
  bool due_ = false;
  double age_s_ = 0.0;
  double cooling_s_ = 0.0;
  double failing_s_ = 0.0;
  bool works_ = true;
};

}  // namespace hedgehog::control
