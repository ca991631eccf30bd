// SPDX-License-Identifier: MIT
#include "daemon/control/winding_visibility.h"

#include <algorithm>
#include <cmath>

#include "model/estimate/thermal_winding_meter.h"

namespace hedgehog::control {
namespace {

constexpr double kRecentS = 0.1;

}  // namespace

void WindingVisibility::step(const TelemetryPair& pair, bool bridges_awake, bool driving,
                             const model::Vec3& predicted_a, double dt_s) noexcept {
  asleep_s_ = bridges_awake || !pair.fresh() ? 0.0 : asleep_s_ + dt_s;
  if (driving) {
    if (unpaired_.step(!pair.consecutive(), dt_s, kBlindAfterS)) blind_ = true;
    if (!unpaired_.pending()) blind_ = false;
  }
  // Decaying peak of the current, held over the zero crossings of a vibration.
  const double keep = std::exp(-dt_s / kRecentS);
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    recent_peak_a_[coil] = std::max(std::abs(predicted_a[coil]), keep * recent_peak_a_[coil]);
    const bool driven = recent_peak_a_[coil] > model::WindingMeter::kMinCurrentA;
    const bool informative = pair.electrical() && pair.informative()[i];
    unmeasured_s_[i] = !driven || informative ? 0.0 : unmeasured_s_[i] + dt_s;
  }
}

}  // namespace hedgehog::control
