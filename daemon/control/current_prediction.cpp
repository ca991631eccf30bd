// SPDX-License-Identifier: MIT
#include "daemon/control/current_prediction.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::control {
namespace {

using model::kTickSeconds;
using model::Tick;
using model::Vec3;

/// Current of a winding of `r` ohm after `ticks` on the way from `from_a` to `settled_a`.
double advanced(double from_a, double settled_a, double r, Tick ticks, double inductance_h) {
  const double rate = r / inductance_h;
  const double keep = std::exp(-rate * kTickSeconds * static_cast<double>(ticks));
  return settled_a + keep * (from_a - settled_a);
}

}  // namespace

void CurrentPrediction::predict_currents(const device::BoardCommand& command,
                                         const WindingCircuit& circuit) noexcept {
  if (command.enable())
    drive(circuit.supply_v * command.first_duty(), 1, circuit);
  else
    sleep(1, circuit);
}

void CurrentPrediction::advance_skipped_ticks(Tick skipped, const device::BoardCommand& command,
                                              const WindingCircuit& circuit) noexcept {
  if (skipped == 0) return;
  const Tick held = std::min(skipped, kLongestGap - 1);
  if (command.enable())
    drive(circuit.supply_v * command.duty(), held, circuit);
  else
    sleep(held, circuit);
  sleep(skipped - held, circuit);
}

void CurrentPrediction::drive(const Vec3& voltage, Tick ticks,
                              const WindingCircuit& circuit) noexcept {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const double r = circuit.resistance_ohm[static_cast<std::size_t>(coil)];
    a_[coil] = advanced(a_[coil], voltage[coil] / r, r, ticks, circuit.inductance_h);
  }
}

// The longest that the current can last: a boost for a current that is larger than predicted would
// overshoot.
void CurrentPrediction::sleep(Tick ticks, const WindingCircuit& circuit) noexcept {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    if (a_[coil] == 0.0) continue;
    const double r = circuit.resistance_ohm[static_cast<std::size_t>(coil)];
    const double opposed_a = std::copysign(kFreewheelV / r, -a_[coil]);
    const double after_a = advanced(a_[coil], opposed_a, r, ticks, circuit.inductance_h);
    // The diodes block a current of the other direction.
    a_[coil] = after_a * a_[coil] > 0.0 ? after_a : 0.0;
  }
}

}  // namespace hedgehog::control
