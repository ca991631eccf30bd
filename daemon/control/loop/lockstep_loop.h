// SPDX-License-Identifier: MIT
// Controller, link and simulated board on one thread (`hedgehogd --simulate --speed N`; the board
// may be a process): device time runs N times as fast as real time.
#pragma once

#include <memory>

#include "daemon/control/loop/loop.h"
#include "daemon/control/loop/pace.h"
#include "daemon/device/simulator/lock_step.h"
#include "daemon/device/simulator/simulated_board.h"

namespace hedgehog::control {

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
