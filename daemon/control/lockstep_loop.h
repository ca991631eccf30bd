// SPDX-License-Identifier: MIT
// Controller, link and simulated board on one thread, several ticks a real millisecond
// (`hedgehogd --simulate --speed N`): device time runs N times as fast as the clock on the wall.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "daemon/control/control_tick.h"
#include "daemon/control/loop.h"
#include "daemon/device/lock_step.h"
#include "daemon/device/simulated_board.h"

namespace hedgehog::control {

/// Nothing is ever skipped here: when the machine is too slow, the whole ball slows down. The
/// thread is an ordinary one. Simulator settings are read from the port as by the link thread.
class LockstepLoop final : public Loop {
 public:
  /// `speed`: 1..100 ticks a millisecond.
  LockstepLoop(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
               FlightRecorder* recorder, const device::SimulatedBoardOptions& board, int speed);
  ~LockstepLoop() override;

  void start() override;
  bool stop() noexcept override;
  std::uint64_t heartbeat() const noexcept override {
    return heartbeat_.load(std::memory_order_relaxed);
  }
  model::Tick now() const noexcept override { return now_.load(std::memory_order_relaxed); }
  std::int64_t origin_ns() const noexcept override { return origin_ns_; }
  bool realtime() const noexcept override { return false; }

 private:
  void run() noexcept;

  int speed_;
  ControlTick tick_;
  device::LockStep world_;
  std::int64_t origin_ns_;
  std::thread thread_;
  bool confirmed_ = false;
  std::atomic<bool> stopping_{false};
  std::atomic<std::uint64_t> heartbeat_{0};
  std::atomic<model::Tick> now_{0};
};

}  // namespace hedgehog::control
