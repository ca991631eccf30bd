// SPDX-License-Identifier: MIT
#include "daemon/control/checks/over_temperature_check.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::control {

using model::kCoils;

OverTemperatureCheck::OverTemperatureCheck(const model::CoilModel& coils,
                                           const model::ThermalModel& thermal) noexcept
    : sensor_winding_(thermal.sensor_winding) {
  for (std::size_t i = 0; i < kCoils; ++i)
    windings_[i] = model::WindingThermometer(coils, thermal, static_cast<int>(i));
}

void OverTemperatureCheck::start_rested() noexcept {
  for (model::WindingThermometer& one : windings_) one.start_rested();
}

void OverTemperatureCheck::follow(const HeatReading& reading, double dt_s) noexcept {
  const bool rested =
      std::all_of(windings_.begin(), windings_.end(), [](const auto& one) { return one.rested(); });
  for (int coil = 0; coil < kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    model::WindingThermometer& winding = windings_[i];
    winding.set_accuracy(reading.accuracy);
    model::WindingReading w;
    w.voltage_v = reading.voltage_v[coil];
    w.before_a = reading.before_a[coil];
    w.after_a = reading.after_a[coil];
    w.measured = reading.electrical && reading.measured[i];
    const double mean_a = 0.5 * (w.before_a + w.after_a);
    const double ohm = winding.resistance_ohm();
    // An unmeasured current is bounded by what the voltage alone would drive.
    w.loss_w = reading.measured[i] ? ohm * mean_a * mean_a : w.voltage_v * w.voltage_v / ohm;
    w.reference = reference_of(reading.thermistors, coil, sensor_winding_, rested);
    winding.step(w, dt_s);
  }
}

double OverTemperatureCheck::coldest_c(const HeatReading& reading) const noexcept {
  const auto own = static_cast<std::size_t>(sensor_winding_);
  const double sensor_c =
      reading.thermistors.valid[own] ? reading.thermistors.celsius[own] : kColdAmbientC;
  return std::min(sensor_c, kColdAmbientC) - kTooColdK;
}

Reason OverTemperatureCheck::step(const HeatReading& reading, double trip_c, double dt_s) noexcept {
  follow(reading, dt_s);
  // A tick without telemetry is no evidence about the thermistors.
  if (reading.fresh) {
    bool high = false;
    for (std::size_t i = 0; i < kCoils; ++i)
      high |= reading.thermistors.valid[i] && reading.thermistors.celsius[i] >= trip_c;
    sensor_due_ = sensor_hot_.step(high, reading.since_s, kHoldS);
  }
  const double coldest = coldest_c(reading);
  bool hot = sensor_due_;
  bool too_cold = false;
  for (int coil = 0; coil < kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    // A held value is no further evidence, neither for nor against.
    const double mean_a = 0.5 * std::abs(reading.before_a[coil] + reading.after_a[coil]);
    const bool shown =
        reading.electrical && reading.measured[i] && mean_a >= model::WindingMeter::kMinCurrentA;
    double since_s = kDecayShare * dt_s;
    bool high = false;
    bool cold = false;
    if (measuring(coil)) {
      if (!shown) continue;
      since_s = dt_s;
      const double error_k = noise_k(coil) + bias_k(coil) + file_k(coil);
      high = winding_c(coil) - error_k >= trip_c;
      cold = winding_c(coil) + error_k < coldest;
    }
    hot |= hot_[i].step(high, since_s, kHoldS);
    too_cold |= too_cold_[i].step(cold, since_s, kTooColdHoldS);
  }
  if (hot) return Reason::kOverheated;
  return too_cold ? Reason::kCurrentMismatch : Reason::kNone;
}

double OverTemperatureCheck::file_k(int coil) const noexcept {
  if (referenced(coil)) return 0.0;
  return kFileShare * kelvins_per_share(model::Celsius(winding_c(coil)));
}

}  // namespace hedgehog::control
