// SPDX-License-Identifier: MIT
// Controller, link and simulated board on one thread (`hedgehogd --simulate --speed N`; the board
// may be a process): device time runs N times as fast as real time.
#pragma once

#include <memory>

#include "daemon/control/loop/loop.h"
#include "daemon/device/simulator/lock_step.h"
#include "daemon/device/simulator/simulated_board.h"

namespace hedgehog::control {

/// How device time advances: at each wake-up by `speed` ticks for each of `step_ms` milliseconds.
/// Fewer wake-ups take less processor time, and effects begin up to `step_ms` later.
struct Pace {
  int speed = 1;    ///< ticks per real millisecond, 1..100
  int step_ms = 1;  ///< real time between two wake-ups, ms, 1..100

  /// At most kMaxTicksPerStep: events of that many ticks have room until io reads them.
  int ticks_per_step() const noexcept { return speed * step_ms; }
};
inline constexpr int kMaxTicksPerStep = 100;

/// No tick is ever skipped: on a slow machine the device time slows down. The thread is not a
/// real-time thread. Simulator settings are read from the port as by the link thread.
class LockstepLoop final : public Loop {
 public:
  /// Out of range, `pace` is clamped, first its speed.
  LockstepLoop(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
               FlightRecorder* recorder, const device::SimulatedBoardOptions& board, Pace pace);
  /// The same with another lock-step board, such as one in a process.
  LockstepLoop(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
               FlightRecorder* recorder, Pace pace, std::unique_ptr<device::SteppedBoard> board);
  ~LockstepLoop() override { stop(); }

 private:
  void run() noexcept override;
  void after_safe_tick() noexcept override { board_->step(); }

  Pace pace_;
  std::unique_ptr<device::SteppedBoard> board_;
};

}  // namespace hedgehog::control
