// SPDX-License-Identifier: MIT
// Board presence, telemetry timeout and the faults that the board reports.
#pragma once

#include <cstdint>

#include "daemon/control/state/state.h"
#include "daemon/device/board_io.h"
#include "model/limit/limits.h"
#include "model/tick.h"

namespace hedgehog::control {

/// The reason for the gravest of the reported board faults; kNone without a fault.
Reason reason_of_faults(std::uint16_t faults) noexcept;

/// `limits`, tightened to the board's if it keeps those of an earlier configuration until its
/// power-up: the current, and the derating law and the trip by the same number of kelvins.
model::Limits limits_within(model::Limits limits, const device::BoardTelemetry& board) noexcept;

/// Control thread; real-time safe, trivially copyable.
class BoardCheck {
 public:
  static constexpr model::Tick kSilence = 100;  // absent after this long without valid telemetry
  static constexpr model::Tick kRestart = 50;   // delay of `restarted`, for frames in transit

  /// Advances by `ticks`.
  void step(bool present, bool fresh, const device::BoardTelemetry& board,
            model::Tick ticks) noexcept;

  /// Present, with valid telemetry within kSilence.
  bool alive() const noexcept { return alive_; }
  /// Ticks since the last telemetry.
  model::Tick age() const noexcept { return age_; }
  /// The fault in the board's last frame.
  Reason fault() const noexcept { return fault_; }
  /// The board is not armed and reports no fault: it has restarted.
  bool restarted() const noexcept { return idle_ >= kRestart; }
  /// Resets the time for which the board has not been armed.
  void expect_armed() noexcept { idle_ = 0; }

 private:
  bool alive_ = false;
  model::Tick age_ = 1'000'000;
  model::Tick idle_ = 0;
  Reason fault_ = Reason::kNone;
};

}  // namespace hedgehog::control
