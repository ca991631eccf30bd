// SPDX-License-Identifier: MIT
// Two consecutive board frames as one measurement of a millisecond: the mean voltage over it and
// the currents at its start and end. The link pairs them, since two may arrive in one tick.
#pragma once

#include <array>
#include <cstdint>

#include "daemon/device/board_io.h"
#include "model/vec3.h"

namespace hedgehog::control {

/// Control thread; real-time safe, trivially copyable.
class TelemetryPair {
 public:
  /// Adds the tick's telemetry; `fresh` when it is new.
  void step(bool fresh, const device::BoardTelemetry& board) noexcept;

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
