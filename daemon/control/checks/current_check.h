// SPDX-License-Identifier: MIT
// Plausibility of the winding currents: compares the measured currents with those that R and L
// predict, once from the duty that the board reports and once from the commands sent. Detects
// current without a set-point and current that R and L do not explain.
#pragma once

#include <array>

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/state/state.h"
#include "model/coils.h"
#include "model/tick.h"
#include "model/vec3.h"

namespace hedgehog::control {

/// Inputs of the check for one tick. Trivially copyable.
struct CurrentReading {
  /// New telemetry arrived in this tick; `follows`: its frame directly follows the previous one.
  bool fresh = false;
  bool follows = false;
  /// Time since the previous telemetry, s.
  double since_s = model::kTickSeconds;
  /// Ticks skipped before this one; meanwhile the board held `held_v` or put its bridges to sleep.
  model::Tick skipped = 0;
  model::Vec3 current_a;
  /// Per winding; false: its current is unknown.
  std::array<bool, model::kCoils> measured{true, true, true};
  /// Voltage applied over the last millisecond as the board reports it, V.
  model::Vec3 applied_v;
  /// Voltage of the last command sent, V; zero when that was the safe command.
  model::Vec3 commanded_v;
  /// The same without the boost.
  model::Vec3 held_v;
};

/// Control thread; real-time safe, trivially copyable. Works at the control tick only.
class CurrentCheck {
 public:
  /// Faults must last this long; transport delays and edges do not. Shorter than the board's own
  /// 20 ms, so that the reason is named here first.
  static constexpr double kHoldS = 0.015;
  /// Permitted current in a winding without a set-point, A.
  static constexpr double kIdleA = 0.5;
  /// Tolerance of the comparisons: noise, and R between 0 and 75 C; L +-20 % moves only edges.
  static constexpr double kOffsetA = 1.0;
  static constexpr double kShare = 0.2;

  CurrentCheck() noexcept = default;
  explicit CurrentCheck(const model::CoilModel& coils) noexcept;

  /// Advances by one tick. kUnexpectedCurrent, kCurrentMismatch or kNone.
  Reason step(const CurrentReading& reading) noexcept;
  /// A fault condition held within the last ticks.
  bool pending() const noexcept;
  /// Currents expected by now from the commands sent, A.
  const model::Vec3& commanded_a() const noexcept { return commanded_a_; }

 private:
  void advance_skipped(const CurrentReading& reading) noexcept;
  Reason check(int coil, const CurrentReading& reading) noexcept;

  struct Winding {
    FaultDebounce unexpected, mismatch;
    FaultDebounce odd;  // by duty alone, which lost frames interrupt
    double conductance_s = 1.0 / 0.45;
    double keep = 0.74;  // exp(-R dt / L)
    double by_duty_a = 0.0;
    double peak_a = 0.0;       // decaying peak of the current expected by duty
    double low_a = 0.0;        // minimum and maximum of the expected current, allowing for some
    double high_a = 0.0;       // milliseconds of delay to the board and back
    double idle_peak_a = 0.0;  // decaying peak of |command|, for the rule of the idle winding
  };

  std::array<Winding, model::kCoils> windings_{};
  model::Vec3 commanded_a_;
  bool by_duty_known_ = false;
};

}  // namespace hedgehog::control
