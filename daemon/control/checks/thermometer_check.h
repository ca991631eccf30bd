// SPDX-License-Identifier: MIT
// Supervision of the configured second thermometer: beside the coil sensor it must agree with it;
// under the skin it derates and trips. Missing readings of a configured thermometer are a fault.
#pragma once

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/state/state.h"
#include "daemon/device/thermometer/sample.h"
#include "model/tick.h"

namespace hedgehog::control {

/// Inputs of the check for one tick. Trivially copyable.
struct ThermometerReading {
  device::ThermometerSample sample;
  model::Tick now = 0;
  bool sensor = false;     // the board's own thermistor is usable
  double sensor_c = 25.0;  // its reading
  double trip_c = 70.0;
};

/// Control thread; real-time safe, trivially copyable.
class ThermometerCheck {
 public:
  /// USB thermometers deliver one or two readings a second.
  static constexpr model::Tick kFresh = 2500;
  static constexpr model::Tick kLost = 5000;
  static constexpr double kLowestC = -40.0;
  static constexpr double kHighestC = 125.0;
  static constexpr double kHotHoldS = 1.5;  // longer than one or two corrupt readings
  /// Deviation from the range of a probe with a lag of 1..40 s beside the thermistor.
  static constexpr double kDisagreeK = 10.0;
  static constexpr double kDisagreeHoldS = 5.0;
  static constexpr double kQuickS = 1.0;
  static constexpr double kSlowS = 40.0;

  ThermometerCheck() noexcept = default;
  explicit ThermometerCheck(device::ThermometerRole role) noexcept : role_(role) {}

  /// Advances by `dt_s`. The reason to trip, or kNone.
  Reason step(const ThermometerReading& reading, double dt_s) noexcept;

  /// A valid reading exists, in `celsius`.
  bool known() const noexcept { return known_; }
  double celsius() const noexcept { return celsius_; }
  /// The reason for which an armed ball would trip now or soon; kNone: arming is not blocked.
  Reason arming_blocker() const noexcept { return arming_blocker_; }
  /// The thermometer is under the skin.
  bool on_shell() const noexcept { return role_ == device::ThermometerRole::kShell; }
  /// The last reading is recent.
  bool fresh() const noexcept { return known_ && age_ <= kFresh; }
  /// Blocks arming after a trip of the skin: no reading, or above 43 C.
  bool too_warm_to_arm() const noexcept;

 private:
  Reason check_coil(const ThermometerReading& reading, double dt_s) noexcept;
  Reason check_shell(double dt_s) noexcept;

  device::ThermometerRole role_ = device::ThermometerRole::kNone;
  Reason arming_blocker_ = Reason::kNone;
  bool known_ = false;
  model::Tick age_ = 0;
  double celsius_ = 0.0;
  FaultDebounce hot_, disagrees_;
  bool following_ = false;
  double quick_c_ = 25.0;  // expected reading beside the thermistor, with the shortest lag
  double slow_c_ = 25.0;   // and with the longest
};

}  // namespace hedgehog::control
