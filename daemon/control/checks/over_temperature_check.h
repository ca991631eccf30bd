// SPDX-License-Identifier: MIT
// Trips at the trip temperature, by the raw thermistors and the watchdog's own V/I of each winding;
// and when V/I is lower than a winding can have: shorted turns, or the device file of another ball.
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

/// Inputs of the check for one tick. Trivially copyable.
struct HeatReading {
  /// New telemetry that directly follows the previous frame: V and both I are of one millisecond.
  bool electrical = false;
  model::Vec3 voltage_v;
  model::Vec3 before_a;
  model::Vec3 after_a;
  std::array<bool, model::kCoils> measured{true, true, true};  // both currents, by winding
  model::CurrentAccuracy accuracy{};
  model::ThermistorReadings thermistors;  // by winding; invalid: no thermistor, or implausible
  bool fresh = true;                      // new telemetry arrived in this tick
  double since_s = model::kTickSeconds;   // since the previous telemetry
};

/// Control thread; real-time safe, trivially copyable.
class OverTemperatureCheck {
 public:
  static constexpr double kHoldS = 0.05;
  /// Decay rate of the hold time while a winding is not measured: pulses of a slow train add up.
  static constexpr double kDecayShare = 0.05;
  /// No winding is this much colder than the lower of the thermistor and kColdAmbientC: a cold
  /// environment and a resistance that is 3 % off explain less.
  static constexpr double kTooColdK = 15.0;
  static constexpr double kColdAmbientC = 20.0;
  static constexpr double kTooColdHoldS = 0.5;
  /// Share; error of V/I by the device file alone, until a winding has rested beside a thermistor.
  static constexpr double kFileShare = 0.05;

  OverTemperatureCheck() noexcept
      : OverTemperatureCheck(model::CoilModel{}, model::ThermalModel{}) {}
  OverTemperatureCheck(const model::CoilModel& coils, const model::ThermalModel& thermal) noexcept;

  /// The ball starts at a uniform temperature, that of its thermistors.
  void start_rested() noexcept;

  /// Advances by `dt_s`. kOverheated: a thermistor or a winding at or above `trip_c` for kHoldS.
  /// kCurrentMismatch: for kTooColdHoldS more current than the resistance of a winding permits.
  Reason step(const HeatReading& reading, double trip_c, double dt_s) noexcept;

  /// V/I of winding `coil` (0..2) is being measured and gives its temperature.
  bool measuring(int coil) const noexcept { return winding(coil).measuring(); }
  double winding_c(int coil) const noexcept { return winding(coil).celsius(); }
  /// Error bounds of winding_c() while measuring: noise, and a bias constant while the current is.
  double noise_k(int coil) const noexcept { return winding(coil).noise_k(); }
  double bias_k(int coil) const noexcept { return winding(coil).bias_k(); }
  /// Compared with a thermistor since the start: the device file's R25 no longer matters.
  bool referenced(int coil) const noexcept { return winding(coil).referenced(); }
  /// Error due to the device file's R25; 0 once the winding is referenced.
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
