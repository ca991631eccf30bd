// SPDX-License-Identifier: MIT
#include "daemon/control/checks/rejected_measurements.h"

namespace hedgehog::control {

void RejectedMeasurements::step(const model::ThermalObserver& observer) noexcept {
  if (!observer.window_ended() || observer.settling()) return;
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const auto& innovations = observer.innovations(coil);
    if (innovations.resistance_known) follow(2 * coil, !innovations.resistance.used);
    if (innovations.thermistor_known) follow(2 * coil + 1, !innovations.thermistor.used);
  }
}

void RejectedMeasurements::follow(int index, bool rejected) noexcept {
  int& windows = differing_windows_[static_cast<std::size_t>(index)];
  windows = rejected == rejected_.contains(index) ? 0 : windows + 1;
  if (windows < (rejected ? kRejectedWindows : kAcceptedWindows)) return;
  rejected_.set(index, rejected);
  windows = 0;
}

}  // namespace hedgehog::control
