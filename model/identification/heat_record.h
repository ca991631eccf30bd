// SPDX-License-Identifier: MIT
// What was measured while a ball was heated and cooled.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace hedgehog::model {

/// Means over a stretch of time in which the same currents were asked for.
struct HeatSample {
  /// How long it lasted, s, and when it ended, s of device time.
  double dt_s = 0.0;
  double end_s = 0.0;
  /// Of voltage times current, of the voltage (signed, V) and of the current (signed, A), each
  /// winding.
  std::array<double, 3> power_w{};
  std::array<double, 3> voltage_v{};
  std::array<double, 3> current_a{};
  /// How many measurements those are; 0: the currents had not settled, so that V/I says nothing.
  int count = 0;
  bool fan_running = false;
  /// The thermometer, C; nullopt: it did not answer.
  std::optional<double> sensor_c;
};

/// Samples without a gap. What was before a run is not known but by its first samples.
struct HeatRun {
  /// It began with a ball at one temperature.
  bool began_at_rest = false;
  std::vector<HeatSample> samples;
};

}  // namespace hedgehog::model
