// SPDX-License-Identifier: MIT
#include "daemon/control/current_prediction.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::control {
namespace {

using model::kTickSeconds;
using model::Tick;
using model::Vec3;

}  // namespace

void CurrentPrediction::predict_currents(const device::BoardCommand& command,
                                         const WindingCircuit& circuit) noexcept {
  advance(circuit.supply_v * command.first_duty(), 1, circuit);
}

void CurrentPrediction::advance_skipped_ticks(Tick skipped, const device::BoardCommand& command,
                                              const WindingCircuit& circuit) noexcept {
  if (skipped == 0) return;
  const Tick held = std::min(skipped, kLongestGap - 1);
  advance(circuit.supply_v * command.duty(), held, circuit);
  // The bridges sleep from here on. The diodes end the current sooner than this model, so no boost
  // becomes too large.
  advance({}, skipped - held, circuit);
}

void CurrentPrediction::advance(const Vec3& voltage, Tick ticks,
                                const WindingCircuit& circuit) noexcept {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const double r = circuit.resistance_ohm[static_cast<std::size_t>(coil)];
    const double goal = voltage[coil] / r;
    const double keep =
        std::exp(-r * kTickSeconds * static_cast<double>(ticks) / circuit.inductance_h);
    a_[coil] = goal + keep * (a_[coil] - goal);
  }
}

}  // namespace hedgehog::control
