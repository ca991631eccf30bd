// SPDX-License-Identifier: MIT
// Measurements of a ball during heating and cooling.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace hedgehog::model {

/// Means over an interval with constant requested currents.
struct HeatSample {
  double dt_s = 0.0;                  // duration
  double end_s = 0.0;                 // device time
  std::array<double, 3> power_w{};    // by winding: mean of voltage times current
  std::array<double, 3> voltage_v{};  // signed
  std::array<double, 3> current_a{};  // signed
  int count = 0;  // measurements averaged; 0: currents had not settled, V/I is not valid
  bool fan_running = false;
  std::optional<double> sensor_c;  // thermistor; nullopt: no reading
};

/// Contiguous samples. The state before a run is known from its first samples only.
struct HeatRun {
  bool began_at_rest = false;  // the ball was at one temperature
  std::vector<HeatSample> samples;
};

}  // namespace hedgehog::model
