// SPDX-License-Identifier: MIT
// The control thread: 1 kHz on an absolute clock.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "daemon/control/control_tick.h"
#include "daemon/control/loop.h"

namespace hedgehog::control {

/// SCHED_FIFO when the system allows it. A tick that was missed is never made up for: the next one
/// is told how many were skipped.
class ControlLoop final : public Loop {
 public:
  ControlLoop(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
              FlightRecorder* recorder);
  ~ControlLoop() override;

  void start() override;
  bool stop() noexcept override;
  std::uint64_t heartbeat() const noexcept override {
    return heartbeat_.load(std::memory_order_relaxed);
  }
  model::Tick now() const noexcept override { return now_.load(std::memory_order_relaxed); }
  std::int64_t origin_ns() const noexcept override { return origin_ns_; }
  bool realtime() const noexcept override { return realtime_; }

 private:
  void run() noexcept;
  void leave() noexcept;

  ControlTick tick_;
  std::int64_t origin_ns_;
  std::thread thread_;
  bool realtime_ = false;
  bool confirmed_ = false;
  std::atomic<bool> started_{false};
  std::atomic<bool> stopping_{false};
  std::atomic<std::uint64_t> heartbeat_{0};
  std::atomic<model::Tick> now_{0};
};

}  // namespace hedgehog::control
