// SPDX-License-Identifier: MIT
// Is any witness of heat at the trip temperature? The thermistor's raw reading, and each winding by
// the watchdog's own V/I. And is one of those no witness: colder than a winding can be, because
// turns are shorted or because the device file has the resistance of another ball?
#pragma once

#include <array>

#include "daemon/control/debounce.h"
#include "daemon/control/state.h"
#include "model/coils.h"
#include "model/thermal_winding_meter.h"
#include "model/tick.h"
#include "model/vec3.h"

namespace hedgehog::control {

/// One tick of what the check sees. Trivially copyable.
struct HeatReading {
  /// Telemetry is new in this tick and follows the last: V, I before and I after belong together,
  /// as one measured millisecond.
  bool electrical = false;
  model::Vec3 voltage_v;
  model::Vec3 before_a;
  model::Vec3 after_a;
  /// Its thermistor is not obviously broken.
  bool sensor = false;
  double sensor_c = 25.0;
  /// New telemetry arrived in this tick, `since_s` after the one before.
  bool fresh = true;
  double since_s = model::kTickSeconds;
};

/// Control thread; real-time safe, trivially copyable.
class HeatCheck {
 public:
  static constexpr double kHoldS = 0.05;
  /// A winding that says nothing is believed to have cooled by so much of the time: the pulses of a
  /// slow train add up.
  static constexpr double kForgets = 0.05;
  /// No winding is this much colder than its thermometer, or than 20 C when that is warmer: a cold
  /// room, and a resistance that is 3 % off, are less.
  static constexpr double kTooColdK = 15.0;
  static constexpr double kColdRoomC = 20.0;
  static constexpr double kTooColdHoldS = 0.5;

  HeatCheck() noexcept : HeatCheck(model::CoilModel{}) {}
  explicit HeatCheck(const model::CoilModel& coils) noexcept;

  /// `dt_s` later. kOverheated when a witness has been at or above `trip_c` for 50 ms;
  /// kCurrentMismatch when more flows, for half a second, than a winding that warm lets through.
  Reason step(const HeatReading& reading, double trip_c, double dt_s) noexcept;

  /// Winding `coil` (0..2) is being measured by its V/I, and its temperature by that.
  bool measuring(int coil) const noexcept;
  double winding_c(int coil) const noexcept;

 private:
  std::array<double, model::kCoils> r25_ohm_{};
  std::array<model::WindingMeter, model::kCoils> meters_{};
  std::array<Debounce, model::kCoils> hot_{};
  std::array<Debounce, model::kCoils> too_cold_{};
  Debounce sensor_hot_;
  bool sensor_due_ = false;
};

}  // namespace hedgehog::control
