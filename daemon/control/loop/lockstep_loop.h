// SPDX-License-Identifier: MIT
// Controller, link and simulated board on one thread, several ticks per real millisecond
// (`hedgehogd --simulate --speed N`; the board may be a process): device time runs N times as fast
// as real time.
#pragma once

#include <memory>

#include "daemon/control/loop/loop.h"
#include "daemon/device/simulator/lock_step.h"
#include "daemon/device/simulator/simulated_board.h"

namespace hedgehog::control {

/// No tick is ever skipped: on a slow machine the device time slows down. The thread is not a
/// real-time thread. Simulator settings are read from the port as by the link thread.
class LockstepLoop final : public Loop {
 public:
  /// `speed`: 1..100 ticks per millisecond.
  LockstepLoop(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
               FlightRecorder* recorder, const device::SimulatedBoardOptions& board, int speed);
  /// The same with another lock-step board, such as one in a process.
  LockstepLoop(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
               FlightRecorder* recorder, int speed, std::unique_ptr<device::SteppedBoard> board);
  ~LockstepLoop() override { stop(); }

 private:
  void run() noexcept override;
  void after_safe_tick() noexcept override { board_->step(); }

  int speed_;
  std::unique_ptr<device::SteppedBoard> board_;
};

}  // namespace hedgehog::control
