// SPDX-License-Identifier: MIT
#include "daemon/device/board_io.h"

#include <algorithm>
#include <cmath>

#include "model/tick.h"

namespace hedgehog::device {
namespace {

constexpr double kFullDuty = 32767.0;

}  // namespace

BoardCommand BoardCommand::drive(const model::LimitedCurrents& currents,
                                 const std::array<double, model::kCoils>& resistance_ohm,
                                 double inductance_h, const model::Vec3& now_a,
                                 double supply_v) noexcept {
  if (!std::isfinite(supply_v) || supply_v <= 0.0) return {};
  BoardCommand command;
  for (int k = 0; k < model::kCoils; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double wanted = currents.a()[k];
    const double voltage =
        resistance_ohm[i] * wanted + inductance_h * (wanted - now_a[k]) / model::kTickSeconds;
    if (!std::isfinite(voltage)) return {};
    const double duty = std::clamp(voltage / supply_v, -1.0, 1.0);
    command.duty_q15_[i] = static_cast<std::int16_t>(std::lround(duty * kFullDuty));
  }
  command.enable_ = true;
  return command;
}

}  // namespace hedgehog::device
