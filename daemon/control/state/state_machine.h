// SPDX-License-Identifier: MIT
// State of the ball: absent, disarmed, armed, tripped. Arming is a handshake: a new arm count is
// sent to the board, and the ball is armed when the board confirms it.
#pragma once

#include <cstdint>

#include "daemon/control/state/control_settings.h"
#include "daemon/control/state/rearm_backoff.h"
#include "daemon/control/state/state.h"
#include "daemon/device/board_io.h"
#include "model/tick.h"

namespace hedgehog::control {

/// Control thread; real-time safe, trivially copyable.
class StateMachine {
 public:
  static constexpr model::Tick kArmTimeout = 300;  // of the board's confirmation
  /// Timeout of a request for the boot loader: by then the board has detached, or will not.
  static constexpr model::Tick kBootLoaderTimeout = 500;

  explicit StateMachine(const ControlSettings& settings) noexcept;

  /// The board is present, or absent (`gone`: kNoBoard, kTelemetryLost). May be called every tick.
  void board_alive(const device::BoardTelemetry& board, model::Tick now) noexcept;
  void board_gone(Reason gone, model::Tick now) noexcept;

  /// Stops and latches. In `tripped` the first reason is kept: one episode.
  void trip(Reason reason, model::Tick now) noexcept;
  void emergency_stop(model::Tick now) noexcept;
  /// The latched reason is no longer known: trips by kStateLost, also while the board is absent.
  void trip_state_lost(model::Tick now) noexcept;
  /// The board has restarted by itself: handled like a hot-plug.
  void board_restarted(model::Tick now) noexcept;

  /// Begins to arm unless `refusal` is a reason against it.
  void arm(Reason refusal, model::Tick now) noexcept;
  /// Requests a board that is neither armed nor being armed to enter its boot loader: until it
  /// detaches, or the timeout, it is not armed, and its loss is not a trip.
  void enter_boot_loader(model::Tick now) noexcept;
  bool boot_loader_pending() const noexcept { return boot_loader_pending_; }
  bool arming() const noexcept { return arming_; }
  /// Arms at the start once not blocked; ends an arming by the board's confirmation or by timeout.
  void step(const device::BoardTelemetry& board, bool fresh, Reason refusal,
            model::Tick now) noexcept;

  State state() const noexcept { return state_; }
  Reason reason() const noexcept { return reason_; }
  model::Tick since() const noexcept { return since_; }
  /// The latch to persist over a restart: a trip or an emergency stop, kNone otherwise.
  Reason latch() const noexcept { return latch_; }
  /// Ticks until the latch may be cleared by arming.
  model::Tick rearm_wait(model::Tick now) const noexcept { return backoff_.wait(latch_, now); }
  const RearmCounts& rearms() const noexcept { return backoff_.counts(); }
  bool armed() const noexcept { return state_ == State::kArmed; }
  std::uint8_t arm_count() const noexcept { return arm_count_; }
  std::uint8_t boot_loader_count() const noexcept { return boot_loader_count_; }

 private:
  void enter(State state, Reason reason, model::Tick now) noexcept;
  void begin_arming(model::Tick now) noexcept;
  bool idle() const noexcept {
    return (state_ == State::kDisarmed || state_ == State::kTripped) && !arming_;
  }

  State state_ = State::kAbsent;
  Reason reason_ = Reason::kNoBoard;
  model::Tick since_ = 0;
  Reason latch_ = Reason::kNone;
  RearmBackoff backoff_;
  Reason start_reason_ = Reason::kNeverArmed;
  model::Tick start_timeout_ = 0;
  bool seen_ = false;
  bool arm_when_sane_ = false;
  bool arming_ = false;
  model::Tick arming_since_ = 0;
  std::uint8_t arm_count_ = 0;
  bool boot_loader_pending_ = false;
  model::Tick boot_loader_since_ = 0;
  std::uint8_t boot_loader_count_ = 0;
};

}  // namespace hedgehog::control
