// SPDX-License-Identifier: MIT
// Trips at the trip temperature by the thermistors' raw readings and by the watchdog's own V/I of
// each winding; and when V/I is below the resistance a winding can have, because turns are shorted
// or because the device file contains the resistance of another ball.
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
  /// Telemetry is new in this tick and directly follows the previous frame: V, I before and I after
  /// are one measured millisecond.
  bool electrical = false;
  model::Vec3 voltage_v;
  model::Vec3 before_a;
  model::Vec3 after_a;
  /// Per winding: its currents before and after were measured.
  std::array<bool, model::kCoils> measured{true, true, true};
  model::CurrentAccuracy accuracy{};
  /// By winding; invalid without a thermistor, or where the reading is implausible.
  model::ThermistorReadings thermistors;
  /// New telemetry arrived in this tick, `since_s` after the previous one.
  bool fresh = true;
  double since_s = model::kTickSeconds;
};

/// Control thread; real-time safe, trivially copyable.
class OverTemperatureCheck {
 public:
  static constexpr double kHoldS = 0.05;
  /// While a winding is not measured its hold time decays at this rate, so that the pulses of a
  /// slow train add up.
  static constexpr double kDecayShare = 0.05;
  /// A winding is never this much colder than its thermistor, or than 20 C if that is warmer: a
  /// cold environment and a resistance that is 3 % off explain less.
  static constexpr double kTooColdK = 15.0;
  static constexpr double kColdAmbientC = 20.0;
  static constexpr double kTooColdHoldS = 0.5;
  /// Error of V/I by the device file alone, a share, until the winding has once rested beside a
  /// thermistor.
  static constexpr double kFileShare = 0.05;

  OverTemperatureCheck() noexcept
      : OverTemperatureCheck(model::CoilModel{}, model::ThermalModel{}) {}
  OverTemperatureCheck(const model::CoilModel& coils, const model::ThermalModel& thermal) noexcept;

  /// The ball starts at a uniform temperature, that of its thermistors.
  void start_rested() noexcept;

  /// Advances by `dt_s`. kOverheated when a thermistor or a winding has been at or above `trip_c`
  /// for 50 ms; kCurrentMismatch when for half a second the current has been higher than the
  /// resistance of a winding at that temperature permits.
  Reason step(const HeatReading& reading, double trip_c, double dt_s) noexcept;

  /// V/I of winding `coil` (0..2) is being measured and gives its temperature.
  bool measuring(int coil) const noexcept { return winding(coil).measuring(); }
  double winding_c(int coil) const noexcept { return winding(coil).celsius(); }
  /// Error bounds of winding_c(), K: noise of the currents, and the bias that is constant while the
  /// current is. Only while measuring.
  double noise_k(int coil) const noexcept { return winding(coil).noise_k(); }
  double bias_k(int coil) const noexcept { return winding(coil).bias_k(); }
  /// The resistance has been compared with a thermistor since the start, so that the device file's
  /// R25 no longer matters.
  bool referenced(int coil) const noexcept { return winding(coil).referenced(); }
  /// Error due to the device file's R25, K: 0 once the winding is referenced.
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
