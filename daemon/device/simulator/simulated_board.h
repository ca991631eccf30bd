// SPDX-License-Identifier: MIT
// Simulated driver board: the firmware's rules and converter readings, with real frames, connected
// to simulated electronics and a simulated ball.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "daemon/device/board_codec.h"
#include "daemon/device/board_core/board_core.h"
#include "daemon/device/simulator/front_end.h"
#include "daemon/device/simulator/simulator_errors.h"
#include "daemon/device/simulator/simulator_settings.h"
#include "model/thermal/plant.h"

namespace hedgehog::device {

struct SimulatedBoardOptions {
  model::PlantParameters plant = with_noise();
  FrontEndChoice front_end;
  double ambient_c = 25.0;
  double start_c = 25.0;  // windings, core and thermistor at the start

  /// The ball that matches its device file, its thermistor with 0.15 K of noise.
  static model::PlantParameters with_noise() noexcept {
    model::PlantParameters plant;
    plant.sensor_noise_k = 0.15;
    return plant;
  }
};

/// Real-time safe, no clock, no thread of its own: `step` is one millisecond.
class SimulatedBoard {
 public:
  static constexpr int kConversionMs = 10;    // interval of thermistor conversions and truth frames
  static constexpr int kBootLoaderMs = 3000;  // without a response; then as newly flashed

  SimulatedBoard() noexcept : SimulatedBoard(SimulatedBoardOptions{}) {}
  explicit SimulatedBoard(const SimulatedBoardOptions& options) noexcept;

  /// One packet from the host, any bytes; any number of them before each `step`.
  void receive(std::span<const std::uint8_t> packet) noexcept;

  /// Measures, applies the rules, and advances the plant by a millisecond with their outputs. The
  /// telemetry has the measurements before that; none while kSimSilent or in the boot loader.
  std::optional<Frame> step() noexcept;
  /// True state of the plant, after every kConversionMs steps.
  std::optional<Frame> truth_frame() const noexcept;
  /// True state of the plant, with the caller's count of milliseconds.
  Frame truth(std::uint32_t now_ms) const noexcept;

  /// Instead of `step`, for a board core that runs elsewhere: advances the plant by a millisecond
  /// with `outputs`, returns the readings after it. Not for a front end without electronics.
  const board::RawInputs& step_electronics(const board::BoardOutputs& outputs) noexcept;

  const model::Plant& plant() const noexcept { return plant_; }  // for tests
  model::Plant& plant() noexcept { return plant_; }
  const board::BoardCore& core() const noexcept { return core_; }
  const SimulatorSettings& settings() const noexcept { return settings_; }
  /// Same effect as the frames of these settings and their errors.
  void apply(const SimulatorSettings& settings) noexcept;
  void set_errors(const SimulatorErrorList& errors) noexcept;

 private:
  board::BoardOutputs step_core() noexcept;
  board::BoardInputs measure() noexcept;
  Analogue convert() noexcept;
  Analogue analogue() const noexcept;
  board::BoardInputs measure_exactly(const Analogue& analogue) noexcept;
  void convert_thermistors(const Analogue& analogue) noexcept;
  void show(int thermistor, double celsius) noexcept;  // sets temperature and converter counts
  void wire_thermistors() noexcept;
  int broken_thermistor() const noexcept;  // affected by the thermistor faults
  int winding_under(int thermistor) const noexcept;
  void act_errors() noexcept;
  void step_plant(const board::BoardOutputs& outputs) noexcept;
  bool has(SimFault fault) const noexcept { return (settings_.faults & fault) != 0; }
  bool touches(SimFault fault, int coil) const noexcept {
    return has(fault) && settings_.coil == coil;
  }

  model::Plant plant_;
  board::BoardLimits full_limits_;  // as built
  board::BoardCore core_;
  SimulatorSettings settings_;
  SimulatorErrors errors_;
  SimulatorErrorReader error_reader_;
  FrontEndParameters built_;  // the electronics without errors
  FrontEnd front_end_;
  board::RawInputs raw_;
  double nominal_supply_v_ = 12.0;
  model::Vec3 driven_duty_;  // of the last millisecond
  bool driven_awake_ = false;
  model::Vec3 before_a_;  // currents at its start
  double offset_k_ = 0.0;
  int until_conversion_ = 0;
  int boot_loader_ms_ = 0;
  /// Reading of each thermistor at its last conversion, C, and the converter's counts for it.
  std::array<double, model::kCoils> shown_c_{25.0, 25.0, 25.0};
  std::array<std::uint16_t, model::kCoils> shown_adc_{};
  std::uint32_t supply_ms_ = 0;
};

}  // namespace hedgehog::device
