// SPDX-License-Identifier: MIT
// Two consecutive board frames as one measurement of a millisecond: the mean voltage over it and
// the currents at its start and end. The link pairs them, since two may arrive in one tick.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "daemon/device/board_io.h"
#include "model/vec3.h"

namespace hedgehog::control {

/// Control thread; real-time safe, trivially copyable.
class TelemetryPair {
 public:
  /// Adds the tick's telemetry; `fresh` when it is new.
  void step(bool fresh, const device::BoardTelemetry& board) noexcept {
    fresh_ = fresh && is_finite(board.current_a) && is_finite(board.duty) &&
             std::isfinite(board.supply_v);
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

  /// New in this tick, all numbers finite.
  bool fresh() const noexcept { return fresh_; }
  /// The preceding frame was received too, so that voltage and both currents belong together.
  bool consecutive() const noexcept { return consecutive_; }
  /// The preceding frame was that of the previous tick: the sequence is unbroken.
  bool follows() const noexcept { return follows_; }
  /// V/I is valid: the bridges were driven throughout this millisecond.
  bool electrical() const noexcept { return consecutive_ && driven_; }
  /// Per winding: both currents were measured; the current at the end was measured.
  const device::Measured& measured() const noexcept { return measured_; }
  const device::Measured& after_measured() const noexcept { return after_measured_; }
  /// Per winding: the currents determine its resistance. A sensor without sign measures only half
  /// of each current reversal, so the current must have kept its direction for 5 L/R.
  const device::Measured& informative() const noexcept { return informative_; }
  const model::Vec3& before_a() const noexcept { return before_a_; }
  const model::Vec3& after_a() const noexcept { return after_a_; }
  const model::Vec3& voltage_v() const noexcept { return voltage_v_; }

 private:
  bool seen_ = false;
  bool fresh_ = false;
  bool consecutive_ = false;
  bool follows_ = false;
  bool driven_ = false;
  device::Measured measured_{true, true, true};
  device::Measured after_measured_{true, true, true};
  device::Measured informative_{};
  static constexpr int kSteady = 17;
  std::array<int, model::kCoils> steady_{};
  std::uint32_t sequence_ = 0;
  model::Vec3 before_a_;
  model::Vec3 after_a_;
  model::Vec3 voltage_v_;
};

}  // namespace hedgehog::control
