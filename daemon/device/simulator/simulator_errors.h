// SPDX-License-Identifier: MIT
// Effect of a list of errors on the simulated ball and its electronics, millisecond by millisecond.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "daemon/device/simulator/front_end.h"
#include "daemon/device/simulator/simulator_error.h"
#include "model/thermal/plant.h"

namespace hedgehog::device {

/// The errors in effect. Real-time safe, trivially copyable; the board's thread.
class SimulatorErrors {
 public:
  /// Replaces all errors and starts their ramps.
  void set(const SimulatorErrorList& list) noexcept;
  /// Advances by one millisecond. True on a change.
  bool step() noexcept;
  const SimulatorErrorList& list() const noexcept { return list_; }

  const model::PlantErrors& plant() const noexcept { return plant_; }
  /// `parameters` with the measurement errors applied.
  FrontEndParameters on(const FrontEndParameters& parameters) const noexcept;
  double tach_gain() const noexcept { return tach_gain_; }
  /// The duty of winding `coil` with a stuck PWM line.
  std::optional<double> stuck_duty(int coil) const noexcept;

 private:
  void act() noexcept;

  SimulatorErrorList list_;
  std::uint64_t elapsed_ms_ = 0;
  bool growing_ = false;
  bool changed_ = false;
  model::PlantErrors plant_;
  std::array<double, model::kCoils> current_gain_{1.0, 1.0, 1.0};
  std::array<double, model::kCoils> current_offset_a_{};
  std::array<double, model::kCoils> thermistor_offset_k_{};
  double supply_gain_ = 1.0;
  double tach_gain_ = 1.0;
  std::array<bool, model::kCoils> stuck_{};
  std::array<double, model::kCoils> stuck_duty_{};
};

}  // namespace hedgehog::device
