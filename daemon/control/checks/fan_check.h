// SPDX-License-Identifier: MIT
// Fan supervision. Fault: no tachometer pulse for 3 s while driven (daemon/safety.md). Cooling is
// credited only by fresh telemetry of a fan that is driven and turns within its range.
#pragma once

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/state/state.h"

namespace hedgehog::control {

/// Fan measurements of one tick. Made and used on the control thread.
struct FanReading {
  bool fresh = false;  // new in this tick; otherwise duty and speed are ignored
  double duty = 0.0;   // applied by the board, 0..1
  double rpm = 0.0;    // by the tachometer
};

/// Control thread; real-time safe, trivially copyable.
class FanCheck {
 public:
  static constexpr double kHoldS = 3.0;
  static constexpr double kMinRpm = 300.0;  // below: stopped; a 7200 rpm fan idles far above
  /// Shares of the full speed between which the tachometer is credited with cooling. A fan at 0.7
  /// cools a fifth less, as much as the thermal constants may be off; one at 1.5 does not exist.
  static constexpr double kMinCoolingShare = 0.7;
  static constexpr double kMaxCoolingShare = 1.5;
  static constexpr double kMinCoolingDuty = 0.9;
  static constexpr double kCoolingHoldS = 0.5;  // time for which the tachometer must be in range
  static constexpr double kMaxAgeS = 0.1;       // of the telemetry
  static constexpr double kMaxStartS = 10.0;    // a driven fan out of range for longer has failed

  FanCheck() noexcept = default;
  explicit FanCheck(double full_rpm) noexcept : full_rpm_(full_rpm) {}

  /// Advances by `dt_s` with the tachometer reading of fresh telemetry: kFanStopped or kNone.
  Reason step(bool commanded, double rpm, double dt_s) noexcept;
  /// Advances by `dt_s`; called in every tick.
  void follow(const FanReading& reading, double dt_s) noexcept;
  /// Restarts the time for which the fan may stand.
  void reset() noexcept;
  /// The fan is driven and did not turn in the last tick.
  bool stalled() const noexcept { return stalled_.pending(); }
  /// The fan has not turned for kHoldS while driven.
  bool stopped() const noexcept { return due_; }
  /// The fan is credited with cooling the core.
  bool cooling() const noexcept;
  /// False after the driven fan was out of range for kMaxStartS, until it is credited with cooling.
  bool works() const noexcept { return works_; }

 private:
  double full_rpm_ = 7200.0;
  FaultDebounce stalled_;
  bool due_ = false;
  double age_s_ = 0.0;
  double cooling_s_ = 0.0;
  double failing_s_ = 0.0;
  bool works_ = true;
};

}  // namespace hedgehog::control
