// SPDX-License-Identifier: MIT
// Thermal model of the ball with four lumped nodes: three windings around one core, the core cooled
// by the fan. Constants: model/thermal-model.md (chosen so that 15 A along one coil warms it from
// 25 to 70 C in 29.6 s, thesis section 3.1.1).
#pragma once

#include <array>

#include "model/coils.h"

namespace hedgehog::model {

/// Heat capacities and thermal resistances of one ball. Trivially copyable.
struct ThermalModel {
  std::array<double, kCoils> winding_j_k{58.81, 58.81, 58.81};
  double core_j_k = 84.4;
  std::array<double, kCoils> winding_to_core_k_w{1.0, 1.0, 1.0};
  double core_to_ambient_fan_k_w = 1.8;
  double core_to_ambient_still_k_w = 5.0;
  int sensor_winding = 0;        // that of the thermistor, 0..2
  double sensor_lag_s = 2.0;     // first-order lag of the thermistor
  double fan_full_rpm = 7200.0;  // at full duty

  friend constexpr bool operator==(const ThermalModel&, const ThermalModel&) noexcept = default;
};

/// Temperatures of the four nodes.
struct ThermalState {
  std::array<double, kCoils> winding_c{25.0, 25.0, 25.0};
  double core_c = 25.0;
};

}  // namespace hedgehog::model
