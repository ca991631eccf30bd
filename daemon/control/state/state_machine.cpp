// SPDX-License-Identifier: MIT
#include "daemon/control/state/state_machine.h"

#include "daemon/control/checks/board_check.h"

namespace hedgehog::control {

StateMachine::StateMachine(const ControlSettings& settings) noexcept
    : latch_(settings.latch),
      backoff_(settings.rearms),
      start_reason_(settings.start_reason),
      start_timeout_(settings.start_timeout),
      arm_when_sane_(settings.arm_at_start && settings.latch == Reason::kNone) {}

void StateMachine::enter(State state, Reason reason, model::Tick now) noexcept {
  if (state == state_ && reason == reason_) return;
  state_ = state;
  reason_ = reason;
  since_ = now;
}

void StateMachine::board_alive(const device::BoardTelemetry& board, model::Tick now) noexcept {
  if (state_ != State::kAbsent) return;
  // The board's own count, so that the first set-point does not arm it.
  arm_count_ = board.arm_count;
  if (latch_ == Reason::kEmergencyStop) {
    enter(State::kDisarmed, latch_, now);
  } else if (latch_ != Reason::kNone) {
    enter(State::kTripped, latch_, now);
  } else {
    const bool plugged_in = seen_ || now > start_timeout_;
    if (plugged_in) arm_when_sane_ = false;
    enter(State::kDisarmed, plugged_in ? Reason::kHotPlug : start_reason_, now);
  }
  seen_ = true;
}

void StateMachine::board_gone(Reason gone, model::Tick now) noexcept {
  arming_ = false;
  // While the board is absent the first reason is kept, so that silence and unplugging are one
  // episode.
  if (state_ != State::kAbsent)
    enter(State::kAbsent, boot_loader_pending_ ? Reason::kBootLoader : gone, now);
  boot_loader_pending_ = false;
}

void StateMachine::trip(Reason reason, model::Tick now) noexcept {
  arming_ = false;
  arm_when_sane_ = false;
  if (state_ == State::kTripped || state_ == State::kAbsent) return;
  latch_ = reason;
  backoff_.trip(now);
  enter(State::kTripped, reason, now);
}

void StateMachine::emergency_stop(model::Tick now) noexcept {
  arming_ = false;
  arm_when_sane_ = false;
  // The latch of a trip is stricter and is kept, also while the board is absent.
  if (latch_ == Reason::kNone) latch_ = Reason::kEmergencyStop;
  if (state_ != State::kAbsent && state_ != State::kTripped) enter(State::kDisarmed, latch_, now);
}

void StateMachine::trip_state_lost(model::Tick now) noexcept {
  trip(Reason::kStateLost, now);
  const bool loose = latch_ == Reason::kNone || latch_ == Reason::kEmergencyStop;
  if (loose) latch_ = Reason::kStateLost;
}

void StateMachine::board_restarted(model::Tick now) noexcept {
  if (state_ == State::kArmed) enter(State::kDisarmed, Reason::kHotPlug, now);
}

void StateMachine::begin_arming(model::Tick now) noexcept {
  arming_ = true;
  arming_since_ = now;
  ++arm_count_;
}

void StateMachine::arm(Reason refusal, model::Tick now) noexcept {
  if (idle() && !boot_loader_pending_ && refusal == Reason::kNone) begin_arming(now);
}

void StateMachine::enter_boot_loader(model::Tick now) noexcept {
  if (!idle()) return;
  arm_when_sane_ = false;
  boot_loader_pending_ = true;
  boot_loader_since_ = now;
  ++boot_loader_count_;
}

void StateMachine::step(const device::BoardTelemetry& board, bool fresh, Reason refusal,
                        model::Tick now) noexcept {
  backoff_.step(state_ == State::kArmed, now);
  if (now - boot_loader_since_ > kBootLoaderTimeout) boot_loader_pending_ = false;
  if (arm_when_sane_ && state_ == State::kDisarmed && refusal == Reason::kNone) {
    arm_when_sane_ = false;
    begin_arming(now);
  }
  if (!arming_) return;
  const bool ready =
      board.mode == device::BoardMode::kReady || board.mode == device::BoardMode::kDriving;
  if (fresh && ready && board.arm_count == arm_count_ && refusal == Reason::kNone) {
    arming_ = false;
    backoff_.arm(latch_, now);
    latch_ = Reason::kNone;
    enter(State::kArmed, Reason::kNone, now);
  } else if (now - arming_since_ > kArmTimeout) {
    // The board keeps its latch, so the cause persists.
    const Reason why = reason_of_faults(board.faults);
    arming_ = false;
    if (why != Reason::kNone) trip(why, now);
  }
}

}  // namespace hedgehog::control
