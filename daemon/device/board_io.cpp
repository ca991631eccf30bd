// SPDX-License-Identifier: MIT
#include "daemon/device/board_io.h"

#include <algorithm>
#include <cmath>

#include "model/tick.h"

namespace hedgehog::device {
namespace {

constexpr int kFull = static_cast<int>(kFullDuty);

int q15(double voltage, double supply_v) noexcept {
  return static_cast<int>(std::lround(std::clamp(voltage / supply_v, -1.0, 1.0) * kFullDuty));
}

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
    const double keep = std::exp(-resistance_ohm[i] * model::kTickSeconds / inductance_h);
    const double holding_v = resistance_ohm[i] * wanted;
    const double first_v = resistance_ohm[i] * (wanted - now_a[k] * keep) / (1.0 - keep);
    if (!std::isfinite(holding_v) || !std::isfinite(first_v)) return {};
    const int holding = q15(holding_v, supply_v);
    const int boost = std::clamp(q15(first_v, supply_v) - holding, -kFull, kFull);
    command.duty_q15_[i] = static_cast<std::int16_t>(holding);
    command.boost_q15_[i] = static_cast<std::int16_t>(boost);
  }
  command.enable_ = true;
  return command;
}

model::Vec3 BoardCommand::first_duty() const noexcept {
  model::Vec3 duty;
  for (int k = 0; k < model::kCoils; ++k) {
    const auto i = static_cast<std::size_t>(k);
    duty[k] = std::clamp(duty_q15_[i] + boost_q15_[i], -kFull, kFull) / kFullDuty;
  }
  return duty;
}

}  // namespace hedgehog::device
