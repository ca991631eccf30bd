// SPDX-License-Identifier: MIT
// A driver board that is not there: the board core, behind real frames, in front of the simulated
// world. The same rules as in a board's firmware, so that everything above can be tested against
// them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "daemon/device/board_codec.h"
#include "daemon/device/board_core/board_core.h"
#include "daemon/device/simulator_settings.h"
#include "model/plant.h"

namespace hedgehog::device {

struct SimulatedBoardOptions {
  model::PlantParameters plant = with_noise();
  /// The room, and the ball's temperature at the start (windings, core and thermistor).
  double ambient_c = 25.0;
  double start_c = 25.0;

  /// The ball that matches its device file, its thermistor with 0.15 K of noise (DESIGN section 6).
  static model::PlantParameters with_noise() noexcept {
    model::PlantParameters plant;
    plant.sensor_noise_k = 0.15;
    return plant;
  }
};

/// Real-time safe, no clock, no thread of its own: `step` is one millisecond.
class SimulatedBoard {
 public:
  /// The thermistor is converted once in so many milliseconds.
  static constexpr int kConversionMs = 10;

  SimulatedBoard() noexcept : SimulatedBoard(SimulatedBoardOptions{}) {}
  explicit SimulatedBoard(const SimulatedBoardOptions& options) noexcept;

  /// One packet from the host, any bytes; any number of them before each `step`.
  void receive(std::span<const std::uint8_t> packet) noexcept;

  /// Measures, decides, and lets the world run for a millisecond on what was decided. The telemetry
  /// holds what was measured at its beginning; none while kSimSilent.
  std::optional<Frame> step() noexcept;

  /// The truth, for tests.
  const model::Plant& plant() const noexcept { return plant_; }
  model::Plant& plant() noexcept { return plant_; }
  const board::BoardCore& core() const noexcept { return core_; }
  const SimulatorSettings& settings() const noexcept { return settings_; }
  /// The same as a SimulatorSettings frame.
  void apply(const SimulatorSettings& settings) noexcept;

 private:
  board::BoardInputs measure() noexcept;
  void convert_sensor(board::BoardInputs& inputs) noexcept;
  void run_world(const board::BoardOutputs& outputs) noexcept;
  bool has(SimFault fault) const noexcept { return (settings_.faults & fault) != 0; }

  model::Plant plant_;
  board::BoardCore core_;
  SimulatorSettings settings_;
  double nominal_supply_v_ = 12.0;
  double reading_c_ = 25.0;
  double offset_k_ = 0.0;
  int until_conversion_ = 0;
};

}  // namespace hedgehog::device
