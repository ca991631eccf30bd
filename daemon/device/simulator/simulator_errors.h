// SPDX-License-Identifier: MIT
// What a list of errors makes of the simulated ball and its electronics, millisecond by
// millisecond.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "daemon/device/simulator/front_end.h"
#include "daemon/device/simulator/simulator_error.h"
#include "model/thermal/plant.h"

namespace hedgehog::device {

/// The errors as they act now. Real-time safe, trivially copyable; the board's thread.
class SimulatorErrors {
 public:
  /// Replaces all; they begin to grow.
  void set(const SimulatorErrorList& list) noexcept;
  /// A millisecond later. True when something has changed.
  bool step() noexcept;
  const SimulatorErrorList& list() const noexcept { return list_; }

  const model::PlantErrors& plant() const noexcept { return plant_; }
  /// `parameters` with the errors of measurement on top.
  FrontEndParameters on(const FrontEndParameters& parameters) const noexcept;
  double tach_gain() const noexcept { return tach_gain_; }
  /// The duty at which the PWM line of winding `coil` is stuck.
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
