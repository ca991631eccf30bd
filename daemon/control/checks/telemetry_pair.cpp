// SPDX-License-Identifier: MIT
#include "daemon/control/checks/telemetry_pair.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::control {

void TelemetryPair::step(bool fresh, const device::BoardTelemetry& board) noexcept {
  fresh_ =
      fresh && is_finite(board.current_a) && is_finite(board.duty) && std::isfinite(board.supply_v);
  consecutive_ = fresh_ && board.before.known && is_finite(board.before.current_a);
  follows_ = consecutive_ && seen_ && board.sequence == sequence_ + 1;
  if (!fresh_) return;
  before_a_ = consecutive_ ? board.before.current_a : board.current_a;
  after_a_ = board.current_a;
  voltage_v_ = board.supply_v * board.duty;
  driven_ = consecutive_ && board.before.bridges_awake;
  for (int k = 0; k < model::kCoils; ++k) {
    const auto i = static_cast<std::size_t>(k);
    after_measured_[i] = board.measured[i];
    measured_[i] = board.measured[i] && (!consecutive_ || board.before.measured[i]);
    const bool one_way = board.before.current_a[k] * board.current_a[k] > 0.0;
    steady_[i] = consecutive_ && measured_[i] && one_way ? std::min(steady_[i] + 1, kSteady) : 0;
    informative_[i] = measured_[i] && (board.accuracy.signs || steady_[i] == kSteady);
  }
  sequence_ = board.sequence;
  seen_ = true;
}

}  // namespace hedgehog::control
