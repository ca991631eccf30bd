// SPDX-License-Identifier: MIT
#include "model/thermal_observer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/thermal_flow.h"

namespace hedgehog::model {
namespace {

// A winding that is hotter than thought is believed at once, a cooler one after half a second.
constexpr double kWarmerS = 0.05;
constexpr double kCoolerS = 0.5;
// A winding this far below the room measures a fault, not a temperature.
constexpr double kImpossiblyColdK = 20.0;
constexpr double kMaxPlausibleA = 100.0;

// Two filters on the thermistor; their difference is its slope, which gives the 2 s lead.
constexpr double kSensorFastS = 0.25;
constexpr double kSensorSlowS = 1.0;
constexpr double kSensorLeadS = 2.0;
// Its last value stands for this long, then the ball counts as hot.
constexpr double kSensorHoldS = 0.1;

// Core and room are learned slowly, and only from windings that are nearly settled.
constexpr double kSettledErrorK = 0.05;
constexpr double kCoreByResistanceS = 60.0;
constexpr double kCoreBySensorS = 30.0;
constexpr double kRoomPerCore = 0.05;
constexpr double kRoomBySensorS = 30.0;
constexpr double kRoomFastestK_s = 0.001;
constexpr double kCoreFastestK_s = 0.05;
constexpr double kRoomLowC = 0.0;
constexpr double kRoomHighC = 45.0;
constexpr double kSensorWarmerS = 6.0;
constexpr double kSensorCoolerK_s = 0.02;

constexpr double kWarmRoomC = 35.0;

bool believable(const Vec3& v, double most) noexcept { return is_finite(v) && norm(v) <= most; }

}  // namespace

ThermalObserver::ThermalObserver(const CoilModel& coils, const ThermalModel& thermal,
                                 const ThermalState& start) noexcept
    : coils_(coils), thermal_(thermal) {
  const auto& w = start.winding_c;
  const double coolest = std::min({w[0], w[1], w[2], start.core_c});
  estimate_.nodes = start;
  estimate_.room_c = coolest < kWarmRoomC ? coolest : 25.0;
  estimate_.hottest_c = hottest_winding(start);
  const double at = w[static_cast<std::size_t>(thermal.sensor_winding)];
  estimate_.sensor_lead_c = at;
  estimate_.expected_sensor_c = at;
  meter_.fill(WindingMeter(coils.inductance_h));
  for (std::size_t i = 0; i < kCoils; ++i)
    estimate_.resistance_ohm[i] = resistance_at(Ohms(coils.r25_ohm[i]), Celsius(w[i])).value;
}

void ThermalObserver::step(const ThermalMeasurement& m, double dt_s) noexcept {
  const bool currents_known =
      believable(m.current_a, kMaxPlausibleA) && believable(m.current_before_a, kMaxPlausibleA);
  if (currents_known) {
    for (int coil = 0; coil < kCoils; ++coil) {
      const double from = m.current_before_a[coil];
      const double to = m.current_a[coil];
      mean_square_a2_[coil] = (from * from + from * to + to * to) / 3.0;
    }
  }
  predict(m, dt_s);
  correct_by_resistance(m, m.electrical_valid && currents_known && is_finite(m.voltage_v), dt_s);
  follow_sensor(m, dt_s);
  if (sensor_seen_ && sensor_silent_s_ == 0.0) correct_by_sensor(dt_s);

  double hottest = estimate_.sensor_lead_c;
  for (std::size_t i = 0; i < kCoils; ++i) {
    const double node = estimate_.nodes.winding_c[i];
    hottest = std::max(hottest, node);
    estimate_.resistance_ohm[i] = resistance_at(Ohms(coils_.r25_ohm[i]), Celsius(node)).value;
  }
  if (sensor_silent_s_ > kSensorHoldS) hottest = std::numeric_limits<double>::infinity();
  estimate_.hottest_c = hottest;
}

void ThermalObserver::predict(const ThermalMeasurement& m, double dt_s) noexcept {
  HeatLoad load;
  load.room_c = estimate_.room_c;
  load.fan_running = m.fan_running;
  for (std::size_t i = 0; i < kCoils; ++i) {
    load.loss_w[i] = estimate_.resistance_ohm[i] * mean_square_a2_[static_cast<int>(i)];
    load.guessed[i] = !estimate_.measuring[i];
  }
  estimate_.nodes = advanced(estimate_.nodes, heating_rates(thermal_, estimate_.nodes, load), dt_s);
}

void ThermalObserver::correct_by_resistance(const ThermalMeasurement& m, bool electrical_valid,
                                            double dt_s) noexcept {
  for (std::size_t i = 0; i < kCoils; ++i) {
    const int coil = static_cast<int>(i);
    WindingMeter& meter = meter_[i];
    meter.step(m.voltage_v[coil], m.current_before_a[coil], m.current_a[coil], electrical_valid,
               dt_s);
    estimate_.measuring[i] = false;
    if (!meter.valid()) continue;
    const double measured_c =
        temperature_at(Ohms(coils_.r25_ohm[i]), Ohms(meter.resistance_ohm())).value;
    if (!(measured_c > estimate_.room_c - kImpossiblyColdK)) continue;
    estimate_.measured[i] = true;
    estimate_.measuring[i] = true;
    double& node = estimate_.nodes.winding_c[i];
    const double error_k = measured_c - node;
    const double tau_s = error_k > 0.0 ? kWarmerS : kCoolerS;
    node += error_k * std::min(1.0, dt_s / tau_s);
    // What must be added for ever is heat that the model's core does not give or take.
    if (std::abs(error_k) < kSettledErrorK) {
      const double missing_w = thermal_.winding_j_k * error_k / tau_s;
      correct_core(missing_w * thermal_.winding_to_core_k_w, kCoreByResistanceS, dt_s);
    }
  }
}

void ThermalObserver::follow_sensor(const ThermalMeasurement& m, double dt_s) noexcept {
  const auto own = static_cast<std::size_t>(thermal_.sensor_winding);
  estimate_.expected_sensor_c += (estimate_.nodes.winding_c[own] - estimate_.expected_sensor_c) *
                                 std::min(1.0, dt_s / thermal_.sensor_lag_s);
  if (!m.sensor_valid || !std::isfinite(m.sensor_c)) {
    sensor_silent_s_ += dt_s;
    return;
  }
  if (!sensor_seen_ || sensor_silent_s_ > kSensorHoldS) {
    sensor_fast_c_ = m.sensor_c;
    sensor_slow_c_ = m.sensor_c;
  }
  sensor_seen_ = true;
  sensor_silent_s_ = 0.0;
  sensor_fast_c_ += (m.sensor_c - sensor_fast_c_) * std::min(1.0, dt_s / kSensorFastS);
  sensor_slow_c_ += (sensor_fast_c_ - sensor_slow_c_) * std::min(1.0, dt_s / kSensorSlowS);
  const double slope_k_s = (sensor_fast_c_ - sensor_slow_c_) / kSensorSlowS;
  estimate_.sensor_lead_c = sensor_fast_c_ + (kSensorLeadS + kSensorFastS) * slope_k_s;
}

// While its winding is not measured by its own resistance, the thermistor is the best there is. It
// may warm the estimate freely and cool it only slowly: it may have come loose.
void ThermalObserver::correct_by_sensor(double dt_s) noexcept {
  const auto own = static_cast<std::size_t>(thermal_.sensor_winding);
  if (estimate_.measuring[own]) return;
  const double error_k = sensor_fast_c_ - estimate_.expected_sensor_c;
  const double pull = error_k * std::min(1.0, dt_s / kSensorWarmerS);
  estimate_.nodes.winding_c[own] += std::max(pull, -kSensorCoolerK_s * dt_s);
  correct_core(error_k, kCoreBySensorS, dt_s);
  correct_room(error_k / kRoomBySensorS, dt_s);
}

void ThermalObserver::correct_core(double core_error_k, double core_tau_s, double dt_s) noexcept {
  const double rate_k_s = std::clamp(core_error_k / core_tau_s, -kCoreFastestK_s, kCoreFastestK_s);
  estimate_.nodes.core_c += rate_k_s * dt_s;
  correct_room(kRoomPerCore * rate_k_s, dt_s);
}

void ThermalObserver::correct_room(double rate_k_s, double dt_s) noexcept {
  const double step_k = std::clamp(rate_k_s, -kRoomFastestK_s, kRoomFastestK_s) * dt_s;
  estimate_.room_c = std::clamp(estimate_.room_c + step_k, kRoomLowC, kRoomHighC);
}

}  // namespace hedgehog::model
