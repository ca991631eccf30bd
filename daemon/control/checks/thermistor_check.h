// SPDX-License-Identifier: MIT
// Plausibility of a thermistor's raw reading: open, short, out of range, jumping, stale, frozen, or
// inconsistent with the watchdog's own V/I of the winding it is mounted on, never with the
// limiter's estimate (daemon/safety.md).
#pragma once

#include <cstdint>

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/state/disagreement.h"
#include "daemon/control/state/state.h"
#include "model/tick.h"

namespace hedgehog::control {

/// Inputs of the check for one tick. Trivially copyable.
struct SensorReading {
  bool fresh = false;  // new telemetry arrived in this tick; otherwise the rest is ignored
  bool open = false;
  bool shorted = false;
  double sensor_c = 25.0;
  std::uint8_t conversions = 0;  // counter of conversions, mod 256
  bool measuring = false;
  double winding_c = 25.0;       // the thermistor's own winding by its V/I; only while `measuring`
  double winding_error_k = 0.0;  // bound; not compared beyond kMaxWindingErrorK
  double winding_bias_k = 0.0;   // the part of it that is constant while the current is
  double since_s = model::kTickSeconds;  // since the previous telemetry
};

/// Control thread; real-time safe, trivially copyable.
class ThermistorCheck {
 public:
  static constexpr double kWireHoldS = 0.005;  // open or short, reported by the board in each frame
  /// Range of plausible temperatures near a hand.
  static constexpr double kLowestC = -20.0;
  static constexpr double kHighestC = 125.0;
  /// Longer than the board takes to report a broken wire, whose reading is also out of range.
  static constexpr double kImplausibleHoldS = 0.04;
  /// Maximum change between conversions, plus per second: 15 A give 2.4 K/s at most, noise 0.15 K.
  static constexpr double kJumpK = 4.0;
  static constexpr double kSlewK_s = 5.0;
  static constexpr double kJumpHoldS = 0.02;
  /// The conversion counter does not change: the reading is not used, then a fault.
  static constexpr double kUnusedAfterS = 0.25;
  static constexpr double kStaleAfterS = 1.0;
  /// The reading stayed within kStillK while its winding should have moved it by kFrozenK (a real
  /// thermistor with a lag of 1..3 s would have followed).
  static constexpr double kStillK = 0.5;
  static constexpr double kFrozenK = 4.9;
  static constexpr double kFrozenHoldS = 0.05;
  /// Deviation from the range of a thermistor with a lag of 1..3 s.
  static constexpr double kDisagreeK = 12.0;
  static constexpr double kDisagreeHoldS = 0.5;
  /// The error of V/I is added to both thresholds (kFrozenK, kDisagreeK); maximum for a comparison.
  static constexpr double kMaxWindingErrorK = 4.0;

  /// Advances by `dt_s`. The reason to trip, or kNone.
  Reason step(const SensorReading& reading, double dt_s) noexcept;

  /// The last reading may be used as a temperature. False as soon as arming_blocker() is set.
  bool usable() const noexcept { return usable_; }
  /// Since the board's last conversion, s: the age of the reading, also while telemetry is lost.
  double age_s() const noexcept { return still_s_; }
  /// The reason for which the thermistor would trip the ball now or soon; kNone if plausible.
  Reason arming_blocker() const noexcept { return arming_blocker_; }

 private:
  bool jumped(const SensorReading& reading, double dt_s) noexcept;
  void follow_winding(const SensorReading& reading, double dt_s) noexcept;
  bool frozen(const SensorReading& reading) const noexcept;
  double disagreement_k(double sensor_c) const noexcept;

  FaultDebounce open_, short_, implausible_, jump_, frozen_, disagrees_;
  bool seen_ = false;
  bool usable_ = false;
  Reason arming_blocker_ = Reason::kSensorStale;
  std::uint8_t conversions_ = 0;
  double still_s_ = 0.0;       // since the last conversion
  double plausible_c_ = 25.0;  // last reading without a jump
  double plausible_age_s_ = 0.0;
  double winding_c_ = 25.0;  // when it was last measured
  double quick_c_ = 25.0;    // expected reading of a thermistor with the shortest lag
  double slow_c_ = 25.0;     // and with the longest
  double unmeasured_s_ = 1e9;
  double moved_sensor_c_ = 25.0;  // the reading at its last change, and both expectations then
  double moved_quick_c_ = 25.0;
  double moved_slow_c_ = 25.0;
  double min_bias_k_ = 0.0;  // minimum and maximum bias of its V/I since then
  double max_bias_k_ = 0.0;
};

/// What the thermistor of winding `coil`, rejected by `reason`, contradicts; broken wire: none.
Disagreement disagreement_of(int coil, Reason reason) noexcept;

}  // namespace hedgehog::control
