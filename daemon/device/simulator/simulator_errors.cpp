// SPDX-License-Identifier: MIT
#include "daemon/device/simulator/simulator_errors.h"

#include <algorithm>

#include "model/tick.h"

namespace hedgehog::device {

void SimulatorErrors::set(const SimulatorErrorList& list) noexcept {
  list_ = list;
  elapsed_ms_ = 0;
  changed_ = true;
  act();
}

bool SimulatorErrors::step() noexcept {
  const bool changed = changed_ || growing_;
  changed_ = false;
  if (growing_) {
    ++elapsed_ms_;
    act();
  }
  return changed;
}

void SimulatorErrors::act() noexcept {
  const double elapsed_s = model::kTickSeconds * static_cast<double>(elapsed_ms_);
  SimulatorErrors now;
  for (std::size_t n = 0; n < list_.count; ++n) {
    const SimulatorError& error = list_.error[n];
    const std::size_t i = std::min<std::size_t>(error.coil, model::kCoils - 1);
    const double none = range_of(error.kind).none;
    const double share = error.ramp_s > 0.0 ? std::min(1.0, elapsed_s / error.ramp_s) : 1.0;
    now.growing_ |= share < 1.0;
    const double value = none + share * (error.value - none);
    switch (error.kind) {
      case SimulatorErrorKind::kCurrentGain:
        now.current_gain_[i] = value;
        break;
      case SimulatorErrorKind::kCurrentOffsetA:
        now.current_offset_a_[i] = value;
        break;
      case SimulatorErrorKind::kSupplyGain:
        now.supply_gain_ = value;
        break;
      case SimulatorErrorKind::kResistanceGain:
        now.plant_.resistance_gain[i] = value;
        break;
      case SimulatorErrorKind::kShortedTurns:
        now.plant_.shorted_turns[i] = value;
        break;
      case SimulatorErrorKind::kPwmStuck:
        now.stuck_[i] = true;
        now.stuck_duty_[i] = value;
        break;
      case SimulatorErrorKind::kThermistorOffsetK:
        now.thermistor_offset_k_[i] = value;
        break;
      case SimulatorErrorKind::kThermistorContact:
        now.plant_.lost_contact[i] = value;
        break;
      case SimulatorErrorKind::kCoolingGain:
        now.plant_.cooling_gain = value;
        break;
      case SimulatorErrorKind::kHeatCapacityGain:
        now.plant_.heat_capacity_gain = value;
        break;
      case SimulatorErrorKind::kTachGain:
        now.tach_gain_ = value;
        break;
    }
  }
  now.list_ = list_;
  now.elapsed_ms_ = elapsed_ms_;
  now.changed_ = changed_;
  *this = now;
}

FrontEndParameters SimulatorErrors::on(const FrontEndParameters& parameters) const noexcept {
  FrontEndParameters p = parameters;
  for (std::size_t i = 0; i < model::kCoils; ++i) {
    p.current_gain[i] *= current_gain_[i];
    p.current_offset_a[i] += current_offset_a_[i];
    p.thermistor_offset_k[i] += thermistor_offset_k_[i];
  }
  p.supply_gain *= supply_gain_;
  return p;
}

std::optional<double> SimulatorErrors::stuck_duty(int coil) const noexcept {
  const auto i = static_cast<std::size_t>(coil);
  if (!stuck_[i]) return std::nullopt;
  return stuck_duty_[i];
}

}  // namespace hedgehog::device
