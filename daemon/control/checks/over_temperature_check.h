// SPDX-License-Identifier: MIT
// Trips at the trip temperature by the thermistors' raw readings and by the watchdog's own V/I of
// each winding; and when V/I shows less than a winding can have, because turns are shorted or
// because the device file has the resistance of another ball.
#pragma once

#include <array>

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/state/state.h"
#include "model/coils.h"
#include "model/estimate/thermistor_readings.h"
#include "model/estimate/winding_thermometer.h"
#include "model/thermal/thermal_model.h"
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
  /// Of each winding: its currents before and after were measured.
  std::array<bool, model::kCoils> measured{true, true, true};
  model::CurrentAccuracy accuracy{};
  /// By winding; not valid where there is none, or where it is obviously broken.
  model::ThermistorReadings thermistors;
  /// New telemetry arrived in this tick, `since_s` after the one before.
  bool fresh = true;
  double since_s = model::kTickSeconds;
};

/// Control thread; real-time safe, trivially copyable.
class OverTemperatureCheck {
 public:
  static constexpr double kHoldS = 0.05;
  /// While a winding is not measured its hold time runs back at this rate: the pulses of a slow
  /// train add up.
  static constexpr double kForgets = 0.05;
  /// No winding is this much colder than its thermometer, or than 20 C when that is warmer: a cold
  /// room, and a resistance that is 3 % off, are less.
  static constexpr double kTooColdK = 15.0;
  static constexpr double kColdAmbientC = 20.0;
  static constexpr double kTooColdHoldS = 0.5;
  /// By the device file alone V/I is no better than this, a share: a winding has to have rested
  /// beside a thermistor once to be known better.
  static constexpr double kFileShare = 0.05;

  OverTemperatureCheck() noexcept
      : OverTemperatureCheck(model::CoilModel{}, model::ThermalModel{}) {}
  OverTemperatureCheck(const model::CoilModel& coils, const model::ThermalModel& thermal) noexcept;

  /// The ball starts at one temperature, that of its thermistors.
  void start_rested() noexcept;

  /// `dt_s` later. kOverheated when a thermistor or a winding has been at or above `trip_c` for 50
  /// ms; kCurrentMismatch when more flows, for half a second, than a winding that warm lets
  /// through.
  Reason step(const HeatReading& reading, double trip_c, double dt_s) noexcept;

  /// Winding `coil` (0..2) is being measured by its V/I, and its temperature by that.
  bool measuring(int coil) const noexcept { return winding(coil).measuring(); }
  double winding_c(int coil) const noexcept { return winding(coil).celsius(); }
  /// What that may be off by, K: the noise of the currents, and what is the same for as long as the
  /// current is. Only while measuring.
  double noise_k(int coil) const noexcept { return winding(coil).noise_k(); }
  double bias_k(int coil) const noexcept { return winding(coil).bias_k(); }
  /// Its resistance has been compared with a thermistor since the start: the device file's R25 no
  /// longer matters.
  bool referenced(int coil) const noexcept { return winding(coil).referenced(); }
  /// What the device file's R25 may be off by, K: none once the winding is referenced.
  double file_k(int coil) const noexcept;

 private:
  const model::WindingThermometer& winding(int coil) const noexcept {
    return windings_[static_cast<std::size_t>(coil)];
  }
  void follow(const HeatReading& reading, double dt_s) noexcept;
  double coldest_c(const HeatReading& reading) const noexcept;

  int sensor_winding_ = 0;
  std::array<model::WindingThermometer, model::kCoils> windings_{};
  std::array<FaultDebounce, model::kCoils> hot_{};
  std::array<FaultDebounce, model::kCoils> too_cold_{};
  FaultDebounce sensor_hot_;
  bool sensor_due_ = false;
};

}  // namespace hedgehog::control
