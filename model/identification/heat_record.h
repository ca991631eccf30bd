// SPDX-License-Identifier: MIT
// Measurements of a ball during heating and cooling.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace hedgehog::model {

/// Means over an interval with constant requested currents.
struct HeatSample {
  /// Duration, s, and end, s of device time.
  double dt_s = 0.0;
  double end_s = 0.0;
  /// By winding: mean of voltage times current, of voltage (signed, V) and of current (signed, A).
  std::array<double, 3> power_w{};
  std::array<double, 3> voltage_v{};
  std::array<double, 3> current_a{};
  /// Number of measurements averaged; 0: the currents had not settled, so that V/I is not valid.
  int count = 0;
  bool fan_running = false;
  /// Thermistor reading, C; nullopt: no reading.
  std::optional<double> sensor_c;
};

/// Contiguous samples. The state before a run is known from its first samples only.
struct HeatRun {
  /// True if the ball was at one temperature at the start.
  bool began_at_rest = false;
  std::vector<HeatSample> samples;
};

}  // namespace hedgehog::model
