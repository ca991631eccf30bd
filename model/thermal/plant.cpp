// SPDX-License-Identifier: MIT
#include "model/thermal/plant.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::model {
namespace {

// Maximum share of a node's distance to its neighbours in one explicit step.
constexpr double kMaxStepShare = 0.5;
// Sufficient for the lightest ball that a device file and sim.set can describe.
constexpr double kMaxParts = 1000.0;

}  // namespace

PlantParameters PlantParameters::of(const CoilModel& coils, const ThermalModel& thermal) noexcept {
  PlantParameters parameters;
  parameters.winding_j_k = thermal.winding_j_k;
  parameters.core_j_k = thermal.core_j_k;
  parameters.winding_to_core_k_w = thermal.winding_to_core_k_w;
  parameters.core_to_ambient_fan_k_w = thermal.core_to_ambient_fan_k_w;
  parameters.core_to_ambient_still_k_w = thermal.core_to_ambient_still_k_w;
  parameters.fan_full_rpm = thermal.fan_full_rpm;
  parameters.r25_ohm = coils.r25_ohm;
  parameters.inductance_h = coils.inductance_h;
  parameters.coil_matrix = coils.matrix;
  parameters.supply_v = coils.supply_v;
  parameters.sensor_winding = thermal.sensor_winding;
  parameters.sensor_lag_s = thermal.sensor_lag_s;
  return parameters;
}

Plant::Plant(const PlantParameters& parameters, double ambient_c) noexcept
    : parameters_(parameters), noise_(parameters.seed), ambient_c_(ambient_c) {
  set_heat({{ambient_c, ambient_c, ambient_c}, ambient_c});
}

void Plant::set_heat(const ThermalState& heat) noexcept {
  heat_ = heat;
  thermistor_c_ = heat.winding_c;
  reading_c_ = sensor_body_c();
  skin_c_ = ambient_c_ + parameters_.skin_share * (heat.core_c - ambient_c_);
}

double Plant::hottest_winding_c() const noexcept {
  return std::max({heat_.winding_c[0], heat_.winding_c[1], heat_.winding_c[2]});
}

double Plant::resistance_ohm(int coil) const noexcept {
  const auto i = static_cast<std::size_t>(coil);
  const double left = (1.0 - errors_.shorted_turns[i]) * errors_.resistance_gain[i];
  return resistance_at(Ohms(left * parameters_.r25_ohm[i]), Celsius(heat_.winding_c[i])).value;
}

double Plant::inductance_h(std::size_t coil) const noexcept {
  const double left = 1.0 - errors_.shorted_turns[coil];
  return left * left * parameters_.inductance_h;
}

PinMotion Plant::pins(const PinArray& array, const PinCurves& curves) const {
  return pin_motion(array, curves, {inverse(parameters_.coil_matrix) * current_a_},
                    parameters_.force_slope_n_a);
}

void Plant::step(const PlantInputs& inputs, double dt_s) noexcept {
  for (int coil = 0; coil < kCoils; ++coil)
    step_winding(coil, inputs.bridge[static_cast<std::size_t>(coil)], inputs.voltage_v[coil], dt_s);
  step_fan(inputs.fan_stopped ? 0.0 : inputs.fan_duty, dt_s);
  step_heat(dt_s);
}

void Plant::step_thermal(const Vec3& mean_square_a2, double fan_duty, double dt_s) noexcept {
  mean_square_a2_ = mean_square_a2;
  step_fan(fan_duty, dt_s);
  step_heat(dt_s);
}

void Plant::step_winding(int coil, BridgeState bridge, double voltage_v, double dt_s) noexcept {
  const double before = current_a_[coil];
  if (bridge == BridgeState::kOpen || (bridge == BridgeState::kAsleep && before == 0.0)) {
    current_a_[coil] = 0.0;
    mean_square_a2_[coil] = 0.0;
    return;
  }
  const double resistance = resistance_ohm(coil);
  const double rate = resistance / inductance_h(static_cast<std::size_t>(coil));
  double duration = dt_s;
  double voltage = voltage_v;
  if (bridge == BridgeState::kAsleep) {
    // The diodes oppose the current and block once it has ended.
    voltage = before > 0.0 ? -parameters_.freewheel_v : parameters_.freewheel_v;
    const double until_zero_s =
        std::log1p(std::abs(before) * resistance / parameters_.freewheel_v) / rate;
    duration = std::min(dt_s, until_zero_s);
  }
  // I(t) = settled + rest exp(-rate t): the current and the integral of its square in closed form.
  const double settled = voltage / resistance;
  const double rest = before - settled;
  const double left = std::exp(-rate * duration);
  const bool ended = bridge == BridgeState::kAsleep && duration < dt_s;
  current_a_[coil] = ended ? 0.0 : settled + rest * left;
  const double integral = settled * settled * duration +
                          2.0 * settled * rest * (1.0 - left) / rate +
                          rest * rest * (1.0 - left * left) / (2.0 * rate);
  mean_square_a2_[coil] = integral / dt_s;
}

void Plant::step_fan(double duty, double dt_s) noexcept {
  const double goal = std::clamp(duty, 0.0, 1.0);
  fan_speed_ += (goal - fan_speed_) * std::min(1.0, dt_s / parameters_.fan_spin_up_s);
}

double Plant::to_ambient_w_k() const noexcept {
  const double still = 1.0 / parameters_.core_to_ambient_still_k_w;
  const double forced = 1.0 / parameters_.core_to_ambient_fan_k_w;
  return errors_.cooling_gain * (still + (forced - still) * fan_speed_);
}

double Plant::fastest_per_s() const noexcept {
  double from_core_w_k = to_ambient_w_k();
  double fastest = 0.0;
  for (std::size_t i = 0; i < kCoils; ++i) {
    const double to_core_w_k = 1.0 / parameters_.winding_to_core_k_w[i];
    from_core_w_k += to_core_w_k;
    fastest = std::max(fastest, to_core_w_k / parameters_.winding_j_k[i]);
  }
  return std::max(fastest, from_core_w_k / parameters_.core_j_k) / errors_.heat_capacity_gain;
}

void Plant::step_heat(double dt_s) noexcept {
  const double parts =
      std::clamp(std::ceil(dt_s * fastest_per_s() / kMaxStepShare), 1.0, kMaxParts);
  for (int part = 0; part < static_cast<int>(parts); ++part) step_nodes(dt_s / parts);
  step_thermistors(dt_s);
  const double skin_c = ambient_c_ + parameters_.skin_share * (heat_.core_c - ambient_c_);
  skin_c_ += (skin_c - skin_c_) * std::min(1.0, dt_s / parameters_.skin_lag_s);
}

void Plant::step_nodes(double dt_s) noexcept {
  const double to_ambient_w_k = this->to_ambient_w_k();
  const double step_s = dt_s / errors_.heat_capacity_gain;
  double into_core_w = to_ambient_w_k * (ambient_c_ - heat_.core_c);
  for (std::size_t i = 0; i < kCoils; ++i) {
    const double loss_w =
        resistance_ohm(static_cast<int>(i)) * mean_square_a2_[static_cast<int>(i)];
    const double to_core_w =
        (heat_.winding_c[i] - heat_.core_c) / parameters_.winding_to_core_k_w[i];
    into_core_w += to_core_w;
    heat_.winding_c[i] += (loss_w - to_core_w) * step_s / parameters_.winding_j_k[i];
  }
  heat_.core_c += into_core_w * step_s / parameters_.core_j_k;
}

void Plant::step_thermistors(double dt_s) noexcept {
  const double share = std::min(1.0, dt_s / parameters_.sensor_lag_s);
  for (std::size_t i = 0; i < kCoils; ++i) {
    const double at =
        heat_.winding_c[i] + errors_.lost_contact[i] * (heat_.core_c - heat_.winding_c[i]);
    thermistor_c_[i] += (at - thermistor_c_[i]) * share;
  }
  reading_c_ = sensor_body_c() + parameters_.sensor_noise_k * noise_.gaussian();
}

}  // namespace hedgehog::model
