// SPDX-License-Identifier: MIT
// The control thread: runs the controller in real time (control_loop.h), or together with the link
// and the simulated board, faster than real time (lockstep_loop.h).
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "daemon/control/loop/control_tick.h"
#include "model/tick.h"

namespace hedgehog::control {

/// `start` and `stop`: one thread (main); others: any. A derived destructor calls `stop`.
class Loop {
 public:
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;
  virtual ~Loop() = default;

  /// Starts the thread. Throws std::system_error on failure.
  void start();

  /// Ends playing effects as `stopped`, sends the safe command, ends the thread. False if the board
  /// has not confirmed within 100 ms that its bridges sleep (its dead-man acts then). Idempotent.
  bool stop() noexcept;

  /// Number of steps. Increases only while ticks advance, so it can feed the systemd watchdog.
  std::uint64_t heartbeat() const noexcept { return heartbeat_.load(std::memory_order_relaxed); }

  /// The tick of the last step: time stamp for orientation samples.
  model::Tick now() const noexcept { return now_.load(std::memory_order_relaxed); }

  /// Device time of tick 0: `time_ns` = origin + tick x 1 000 000. CLOCK_MONOTONIC in real time.
  std::int64_t origin_ns() const noexcept { return origin_ns_; }

  /// The thread has real-time scheduling. Valid after `start`.
  bool realtime() const noexcept { return realtime_; }

 protected:
  /// `speed`: ticks per millisecond.
  Loop(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
       FlightRecorder* recorder, int speed = 1);

  /// Requests real-time scheduling; true on success. On the thread, before its first tick.
  virtual bool schedule() noexcept { return false; }
  /// Runs ticks until `stopping`. On the thread.
  virtual void run() noexcept = 0;
  /// Called after each safe command of the shutdown, so that the board can respond. On the thread.
  virtual void after_safe_tick() noexcept = 0;

  bool stopping() const noexcept { return stopping_.load(std::memory_order_acquire); }
  /// Called after `steps` ticks, the last of which was `now`.
  void advance(model::Tick now, std::uint64_t steps) noexcept {
    now_.store(now, std::memory_order_relaxed);
    heartbeat_.fetch_add(steps, std::memory_order_relaxed);
  }
  ControlTick& tick() noexcept { return tick_; }

 private:
  void shut_down() noexcept;

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
