// SPDX-License-Identifier: MIT
#include "daemon/control/checks/rejected_measurements.h"

#include <utility>

namespace hedgehog::control {

void RejectedMeasurements::step(const model::ThermalObserver& observer, double dt_s) noexcept {
  window_s_ += dt_s;
  if (!observer.window_ended()) return;
  const double window_s = std::exchange(window_s_, 0.0);
  if (observer.settling()) return;
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const auto& innovations = observer.innovations(coil);
    if (innovations.resistance_known) follow(2 * coil, !innovations.resistance.used, window_s);
    if (innovations.thermistor_known) follow(2 * coil + 1, !innovations.thermistor.used, window_s);
  }
}

void RejectedMeasurements::follow(int index, bool rejected, double window_s) noexcept {
  double& differing_s = differing_s_[static_cast<std::size_t>(index)];
  differing_s = rejected == rejected_.contains(index) ? 0.0 : differing_s + window_s;
  constexpr double kRoundingS = 1e-9;
  if (differing_s < (rejected ? kRejectedS : kAcceptedS) - kRoundingS) return;
  rejected_.set(index, rejected);
  differing_s = 0.0;
}

}  // namespace hedgehog::control
