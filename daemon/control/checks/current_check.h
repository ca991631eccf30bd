// SPDX-License-Identifier: MIT
// Plausibility of the winding currents: compares measured currents with what R and L let one
// expect, once from the duty that the board reports, and once from our own commands:
// coils that carry current without a set-point, currents that R and L do not explain.
#pragma once

#include <array>

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/state/state.h"
#include "model/coils.h"
#include "model/tick.h"
#include "model/vec3.h"

namespace hedgehog::control {

/// One tick of what the check sees. Trivially copyable.
struct CurrentReading {
  /// New telemetry arrived in this tick; `follows`: from the frame right after the last one.
  bool fresh = false;
  bool follows = false;
  /// Since the telemetry before it, s.
  double since_s = model::kTickSeconds;
  /// Ticks that were never run before this one; the board held `held_v` or went to sleep.
  model::Tick skipped = 0;
  model::Vec3 current_a;
  /// Of each winding: where false, nothing is known of its current.
  std::array<bool, model::kCoils> measured{true, true, true};
  /// Voltage applied over the last millisecond as the board reports it, V.
  model::Vec3 applied_v;
  /// Voltage of our own last command, V; zero when it was the safe one.
  model::Vec3 commanded_v;
  /// The same without its boost.
  model::Vec3 held_v;
};

/// Control thread; real-time safe, trivially copyable. Works at the control tick only.
class CurrentCheck {
 public:
  /// Faults must last this long; transport delays and edges do not. Shorter than the board's own
  /// 20 ms, so that the reason is named here first.
  static constexpr double kHoldS = 0.015;
  /// What may flow in a winding of which nothing was asked, A.
  static constexpr double kIdleA = 0.5;
  /// Tolerance of the comparisons: noise, and R between 0 and 75 C; L +-20 % moves only edges.
  static constexpr double kOffsetA = 1.0;
  static constexpr double kShare = 0.2;

  CurrentCheck() noexcept = default;
  explicit CurrentCheck(const model::CoilModel& coils) noexcept;

  /// One tick later. kUnexpectedCurrent, kCurrentMismatch or kNone.
  Reason step(const CurrentReading& reading) noexcept;
  /// Something was wrong in the last ticks.
  bool pending() const noexcept;
  /// What our own commands should have made flow by now, A.
  const model::Vec3& commanded_a() const noexcept { return commanded_a_; }

 private:
  void sleep_through(const CurrentReading& reading) noexcept;
  Reason judge(int coil, const CurrentReading& reading) noexcept;

  struct Winding {
    FaultDebounce unexpected, mismatch;
    FaultDebounce odd;  // by duty alone, which lost frames interrupt
    double conductance_s = 1.0 / 0.45;
    double keep = 0.74;  // exp(-R dt / L)
    double by_duty_a = 0.0;
    double peak_a = 0.0;       // decaying peak of what is expected by duty
    double low_a = 0.0;        // between them the current should be, allowing for some
    double high_a = 0.0;       // milliseconds on the way to the board and back
    double idle_peak_a = 0.0;  // decaying peak of |command|, for the rule of the idle winding
  };

  std::array<Winding, model::kCoils> windings_{};
  model::Vec3 commanded_a_;
  bool by_duty_known_ = false;
};

}  // namespace hedgehog::control
