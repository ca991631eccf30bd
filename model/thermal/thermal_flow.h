// SPDX-License-Identifier: MIT
// Heating rates of the four nodes by the nominal model, shared by observer and forecast.
#pragma once

#include <algorithm>
#include <array>

#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// Inputs of the thermal network. Trivially copyable.
struct HeatLoad {
  /// Copper loss of each winding, W.
  std::array<double, kCoils> loss_w{};
  double ambient_c = 25.0;
  bool fan_running = false;
};

/// Kelvins per second of each node.
constexpr ThermalState heating_rates(const ThermalModel& model, const ThermalState& nodes,
                                     const HeatLoad& load) noexcept {
  ThermalState rates;
  const double to_ambient_k_w =
      load.fan_running ? model.core_to_ambient_fan_k_w : model.core_to_ambient_still_k_w;
  double into_core_w = (load.ambient_c - nodes.core_c) / to_ambient_k_w;
  for (std::size_t i = 0; i < kCoils; ++i) {
    const double to_core_w = (nodes.winding_c[i] - nodes.core_c) / model.winding_to_core_k_w[i];
    into_core_w += to_core_w;
    rates.winding_c[i] = (load.loss_w[i] - to_core_w) / model.winding_j_k[i];
  }
  rates.core_c = into_core_w / model.core_j_k;
  return rates;
}

/// `nodes` after `dt_s` at constant `rates`.
constexpr ThermalState advanced(ThermalState nodes, const ThermalState& rates,
                                double dt_s) noexcept {
  for (std::size_t i = 0; i < kCoils; ++i) nodes.winding_c[i] += dt_s * rates.winding_c[i];
  nodes.core_c += dt_s * rates.core_c;
  return nodes;
}

/// The hottest of the three windings, degrees Celsius.
constexpr double hottest_winding(const ThermalState& nodes) noexcept {
  const auto& w = nodes.winding_c;
  const double xy = w[0] > w[1] ? w[0] : w[1];
  return xy > w[2] ? xy : w[2];
}

/// True if the nodes' temperatures are equal within the measurement error.
constexpr bool at_one_temperature(const ThermalState& nodes) noexcept {
  constexpr double kOneTemperatureK = 1.0;
  const auto& w = nodes.winding_c;
  const double coolest = std::min({w[0], w[1], w[2], nodes.core_c});
  return std::max(hottest_winding(nodes), nodes.core_c) - coolest < kOneTemperatureK;
}

}  // namespace hedgehog::model
