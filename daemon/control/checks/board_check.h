// SPDX-License-Identifier: MIT
// Board presence, telemetry timeout and the faults that the board reports.
#pragma once

#include <cstdint>

#include "daemon/control/state/state.h"
#include "daemon/device/board_io.h"
#include "model/limit/limits.h"
#include "model/tick.h"

namespace hedgehog::control {

/// The reason for a fault that the board has found, the gravest first; kNone for none.
Reason reason_of_faults(std::uint16_t faults) noexcept;

/// `limits`, as far as a board allows them that still keeps to tighter ones of an earlier
/// configuration (until its power-up): the current, and the law and the trip by as many kelvins.
model::Limits limits_within(model::Limits limits, const device::BoardTelemetry& board) noexcept;

/// Control thread; real-time safe, trivially copyable.
class BoardCheck {
 public:
  /// Without valid telemetry for this long the ball counts as gone.
  static constexpr model::Tick kSilence = 100;
  /// An armed board that neither drives nor tells a fault has restarted; this long is patience for
  /// frames on their way.
  static constexpr model::Tick kRestart = 50;

  /// `ticks` later.
  void step(bool present, bool fresh, const device::BoardTelemetry& board,
            model::Tick ticks) noexcept;

  /// Present, and heard within the last 100 ms.
  bool alive() const noexcept { return alive_; }
  /// Ticks since the last telemetry.
  model::Tick age() const noexcept { return age_; }
  /// The fault in the board's last frame.
  Reason fault() const noexcept { return fault_; }
  /// It is not armed and reports no fault: it has restarted.
  bool restarted() const noexcept { return idle_ >= kRestart; }
  /// Forgets how long it has not been armed.
  void expect_armed() noexcept { idle_ = 0; }

 private:
  bool alive_ = false;
  model::Tick age_ = 1'000'000;
  model::Tick idle_ = 0;
  Reason fault_ = Reason::kNone;
};

}  // namespace hedgehog::control
