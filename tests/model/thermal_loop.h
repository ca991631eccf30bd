// SPDX-License-Identifier: MIT
// Plant, observer, limiter and fan rule in a closed loop on virtual time, without board and
// controller: the thermal behaviour alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/estimate/thermal_observer.h"
#include "model/limit/thermal_limiter.h"
#include "model/thermal/plant.h"

namespace hedgehog::model {

class ThermalLoop {
 public:
  /// `known`: model of the device file; `real`: parameters of the ball.
  ThermalLoop(const PlantParameters& real, double ambient_c, const CoilModel& known = {})
      : plant(real, ambient_c), known_(known) {
    thermal_.sensor_winding = real.sensor_winding;
    start_at(plant.heat());
  }

  void start_at(const ThermalState& heat) {
    plant.set_heat(heat);
    ThermalStart start;
    start.nodes = heat;
    start.known = true;
    start.measured.fill(true);
    observer = ThermalObserver(known_, thermal_, start);
  }

  /// One tick of 1 ms with real voltages and currents. `sensor_c`: the thermistor's reading.
  void tick(const Vec3& requested_a, double sensor_c, bool sensor_valid = true) {
    const Vec3 before = plant.current_a();
    driven = unlimited ? requested_a : limiter.limit({requested_a}, observer.estimate()).a();
    PlantInputs inputs;
    inputs.bridge.fill(BridgeState::kDriven);
    inputs.fan_duty = fan_duty();
    const double supply_v = plant.parameters().supply_v;
    for (int coil = 0; coil < kCoils; ++coil) {
      const double demanded_v =
          observer.estimate().resistance_ohm[static_cast<std::size_t>(coil)] * driven[coil] +
          known_.inductance_h * (driven[coil] - before[coil]) / kTickSeconds;
      inputs.voltage_v[coil] = std::clamp(demanded_v, -supply_v, supply_v);
    }
    plant.step(inputs, kTickSeconds);
    observe(inputs.voltage_v, before, plant.current_a(), sensor_c, sensor_valid, kTickSeconds);
  }
  void tick(const Vec3& requested_a) { tick(requested_a, plant.sensor_c()); }

  /// A step of 20 ms: currents settle at once, voltages are resistive.
  void coarse_tick(const Vec3& requested_a, double sensor_c, bool sensor_valid = true) {
    driven = limiter.limit({requested_a}, observer.estimate(), kCoarseS).a();
    Vec3 squares;
    Vec3 voltage;
    for (int coil = 0; coil < kCoils; ++coil) {
      squares[coil] = driven[coil] * driven[coil];
      voltage[coil] = driven[coil] * plant.resistance_ohm(coil);
    }
    plant.step_thermal(squares, fan_duty(), kCoarseS);
    observe(voltage, driven, driven, sensor_c, sensor_valid, kCoarseS);
  }
  void coarse_tick(const Vec3& requested_a) { coarse_tick(requested_a, plant.sensor_c()); }

  static constexpr double kCoarseS = 20e-3;

  Plant plant;

 private:
  CoilModel known_;
  ThermalModel thermal_;

 public:
  ThermalObserver observer;
  ThermalLimiter limiter{Limits{}};
  /// The limiter's output of the last tick.
  Vec3 driven;
  bool unlimited = false;
  bool fan_works = true;
  /// The maximum temperature of any winding so far, and the longest time for which the higher of
  /// raw thermistor and V/I was continuously above 70 C.
  double hottest_ever_c = -273.0;
  double longest_above_trip_s = 0.0;

 private:
  double fan_duty() {
    const double hottest = *std::max_element(observer.estimate().nodes.winding_c.begin(),
                                             observer.estimate().nodes.winding_c.end());
    if (hottest > 40.0 || mean_a_ > 3.0) fan_on_ = true;
    if (hottest < 35.0 && mean_a_ <= 3.0) fan_on_ = false;
    return fan_on_ && fan_works ? 1.0 : 0.0;
  }

  void observe(const Vec3& voltage, const Vec3& before, const Vec3& after, double sensor_c,
               bool sensor_valid, double dt_s) {
    mean_a_ += (norm(after) - mean_a_) * dt_s / 30.0;
    ThermalMeasurement m;
    m.voltage_v = voltage;
    m.current_before_a = before;
    m.current_a = after;
    m.electrical_valid = true;
    const auto own = static_cast<std::size_t>(thermal_.sensor_winding);
    m.thermistors.celsius[own] = sensor_c;
    m.thermistors.valid[own] = sensor_valid;
    m.fan_running = plant.fan_rpm() > 0.5 * plant.parameters().fan_full_rpm;
    observer.step(m, dt_s);
    bool above = sensor_valid && sensor_c >= 70.0;
    for (int coil = 0; coil < kCoils; ++coil) {
      const auto i = static_cast<std::size_t>(coil);
      WindingMeter& meter = watch_[i];
      meter.step(voltage[coil], before[coil], after[coil], true, dt_s);
      above = above ||
              (meter.valid() &&
               temperature_at(Ohms(known_.r25_ohm[i]), Ohms(meter.resistance_ohm())).value >= 70.0);
    }
    above_s_ = above ? above_s_ + dt_s : 0.0;
    longest_above_trip_s = std::max(longest_above_trip_s, above_s_);
    hottest_ever_c = std::max(hottest_ever_c, plant.hottest_winding_c());
  }

  std::array<WindingMeter, kCoils> watch_{};
  double mean_a_ = 0.0;
  double above_s_ = 0.0;
  bool fan_on_ = false;
};

/// A ball and an ambient temperature from the range that the limiter must tolerate: every constant
/// within 20 %, sensor lag 1..3 s, noise 0.15 K. The device file contains the exact resistances
/// (they are calibrated per coil).
inline PlantParameters random_plant(std::uint64_t seed) {
  RandomStream random(seed);
  const auto scale = [&random](double& value) { value *= random.uniform(0.8, 1.2); };
  PlantParameters p;
  for (double& value : p.winding_j_k) scale(value);
  for (double& value : p.winding_to_core_k_w) scale(value);
  for (double& value : p.r25_ohm) scale(value);
  scale(p.core_j_k);
  scale(p.core_to_ambient_fan_k_w);
  scale(p.core_to_ambient_still_k_w);
  scale(p.inductance_h);
  p.sensor_winding = static_cast<int>(random.bits() % 3);
  p.sensor_lag_s = random.uniform(1.0, 3.0);
  p.sensor_noise_k = 0.15;
  p.seed = seed;
  return p;
}

/// The device file of that ball: its resistances, all else nominal.
inline CoilModel device_file_of(const PlantParameters& p) {
  CoilModel coils;
  coils.r25_ohm = p.r25_ohm;
  return coils;
}

}  // namespace hedgehog::model
