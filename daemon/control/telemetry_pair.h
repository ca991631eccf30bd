// SPDX-License-Identifier: MIT
// Two board frames in a row, as one measurement of a millisecond: the mean voltage over it and the
// currents at its start and end.
#pragma once

#include <cmath>
#include <cstdint>

#include "daemon/device/board_io.h"
#include "model/vec3.h"

namespace hedgehog::control {

/// Control thread; real-time safe, trivially copyable.
class TelemetryPair {
 public:
  /// The tick's telemetry; `fresh` when it is new.
  void step(bool fresh, const device::BoardTelemetry& board) noexcept {
    fresh_ = fresh && is_finite(board.current_a) && is_finite(board.duty) &&
             std::isfinite(board.supply_v);
    consecutive_ = fresh_ && seen_ && board.sequence == sequence_ + 1;
    if (!fresh_) return;
    before_a_ = consecutive_ ? after_a_ : board.current_a;
    after_a_ = board.current_a;
    voltage_v_ = board.supply_v * board.duty;
    driven_ = consecutive_ && awake_;
    awake_ = board.bridges_awake;
    sequence_ = board.sequence;
    seen_ = true;
  }

  /// New in this tick, and every number in it is one.
  bool fresh() const noexcept { return fresh_; }
  /// It follows the frame before, so that voltage and both currents belong together.
  bool consecutive() const noexcept { return consecutive_; }
  /// V/I may be taken: the bridges drove through this millisecond.
  bool electrical() const noexcept { return consecutive_ && driven_; }
  const model::Vec3& before_a() const noexcept { return before_a_; }
  const model::Vec3& after_a() const noexcept { return after_a_; }
  const model::Vec3& voltage_v() const noexcept { return voltage_v_; }

 private:
  bool seen_ = false;
  bool fresh_ = false;
  bool consecutive_ = false;
  bool awake_ = false;   // since the last frame
  bool driven_ = false;  // between the last two
  std::uint32_t sequence_ = 0;
  model::Vec3 before_a_;
  model::Vec3 after_a_;
  model::Vec3 voltage_v_;
};

}  // namespace hedgehog::control
