// SPDX-License-Identifier: MIT
// Plausibility of the winding currents: detects current without a set-point, and current other than
// R and L predict from the duty that the board reports and from the commands sent.
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
  bool fresh = false;                    // new telemetry arrived in this tick
  bool follows = false;                  // its frame directly follows the previous one
  double since_s = model::kTickSeconds;  // since the previous telemetry
  /// Ticks skipped before this one; meanwhile the board held `held_v` or put its bridges to sleep.
  model::Tick skipped = 0;
  model::Vec3 current_a;
  std::array<bool, model::kCoils> measured{true, true, true};  // false: current is unknown
  model::Vec3 applied_v;    // over the last millisecond, as the board reports it
  model::Vec3 commanded_v;  // of the last command sent; zero when that was the safe command
  model::Vec3 held_v;       // the same without the boost
};

/// Control thread; real-time safe, trivially copyable. Works at the control tick only.
class CurrentCheck {
 public:
  /// Longer than transport delays and edges; shorter than the board's 20 ms, to trip before it.
  static constexpr double kHoldS = 0.015;
  static constexpr double kIdleA = 0.5;  // permitted in a winding without a set-point
  /// Tolerance of the comparisons: noise, and R between 0 and 75 C; L +-20 % moves only edges.
  static constexpr double kOffsetA = 1.0;
  static constexpr double kShare = 0.2;

  CurrentCheck() noexcept = default;
  explicit CurrentCheck(const model::CoilModel& coils) noexcept;

  /// Advances by one tick. kUnexpectedCurrent, kCurrentMismatch or kNone.
  Reason step(const CurrentReading& reading) noexcept;
  /// A fault condition held within the last ticks.
  bool pending() const noexcept;
  /// Currents expected by now from the commands sent.
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
