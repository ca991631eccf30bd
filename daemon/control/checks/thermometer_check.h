// SPDX-License-Identifier: MIT
// Supervision of the second thermometer, when one is configured: beside the coil sensor it must
// agree with it; under the skin it reduces and trips. Once configured, its silence is a fault.
#pragma once

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/state/state.h"
#include "daemon/device/thermometer/sample.h"
#include "model/tick.h"

namespace hedgehog::control {

/// One tick of what the check sees. Trivially copyable.
struct ThermometerReading {
  device::ThermometerSample sample;
  model::Tick now = 0;
  /// The board's own thermistor; `sensor`: it may be believed.
  bool sensor = false;
  double sensor_c = 25.0;
  double trip_c = 70.0;
};

/// Control thread; real-time safe, trivially copyable.
class ThermometerCheck {
 public:
  /// Sticks answer once or twice a second.
  static constexpr model::Tick kFresh = 2500;
  static constexpr model::Tick kLost = 5000;
  static constexpr double kLowestC = -40.0;
  static constexpr double kHighestC = 125.0;
  /// Longer than one or two readings with a wrong byte.
  static constexpr double kHotHoldS = 1.5;
  /// Further than this from where a probe with a lag of 1..40 s beside the thermistor could be.
  static constexpr double kDisagreeK = 10.0;
  static constexpr double kDisagreeHoldS = 5.0;
  static constexpr double kQuickS = 1.0;
  static constexpr double kSlowS = 40.0;

  ThermometerCheck() noexcept = default;
  explicit ThermometerCheck(device::ThermometerRole role) noexcept : role_(role) {}

  /// `dt_s` later. The reason to trip, or kNone.
  Reason step(const ThermometerReading& reading, double dt_s) noexcept;

  /// It answers, with `celsius`.
  bool known() const noexcept { return known_; }
  double celsius() const noexcept { return celsius_; }
  /// Why an armed ball would trip now or soon; kNone: nothing speaks against arming.
  Reason arming_blocker() const noexcept { return arming_blocker_; }
  /// It is under the skin.
  bool on_shell() const noexcept { return role_ == device::ThermometerRole::kShell; }
  /// It has answered lately.
  bool fresh() const noexcept { return known_ && age_ <= kFresh; }
  /// After a trip of the skin: it is silent, or no cooler than 43 C.
  bool too_warm_to_arm() const noexcept;

 private:
  Reason judge_coil(const ThermometerReading& reading, double dt_s) noexcept;
  Reason judge_shell(double dt_s) noexcept;

  device::ThermometerRole role_ = device::ThermometerRole::kNone;
  Reason arming_blocker_ = Reason::kNone;
  bool known_ = false;
  model::Tick age_ = 0;
  double celsius_ = 0.0;
  FaultDebounce hot_, disagrees_;
  // Where probes with the shortest and the longest lag beside the thermistor would be.
  bool following_ = false;
  double quick_c_ = 25.0;
  double slow_c_ = 25.0;
};

}  // namespace hedgehog::control
