// SPDX-License-Identifier: MIT
// What turns the controller: in real time (control_loop.h), or together with the link and the
// simulated board, faster than real time (lockstep_loop.h).
#pragma once

#include <cstdint>

#include "model/tick.h"

namespace hedgehog::control {

/// `start` and `stop` are called by one thread (main); the rest by any.
class Loop {
 public:
  Loop() = default;
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;
  virtual ~Loop() = default;

  /// Starts the thread. Throws std::system_error when it cannot.
  virtual void start() = 0;

  /// Makes the coils safe, then ends the thread. Returns when the safe command has gone out: true
  /// when the board has confirmed that its bridges sleep, false when it did not answer within
  /// 100 ms (its dead-man then does it). Effects that played end as `stopped`. A second call does
  /// nothing.
  virtual bool stop() noexcept = 0;

  /// Steps made so far. Rises only while ticks advance, so it can feed the systemd watchdog.
  virtual std::uint64_t heartbeat() const noexcept = 0;

  /// The tick of the last step: stamps for orientation samples.
  virtual model::Tick now() const noexcept = 0;

  /// Device time of tick 0, ns: `time_ns` = origin + tick x 1 000 000. CLOCK_MONOTONIC in real
  /// time.
  virtual std::int64_t origin_ns() const noexcept = 0;

  /// The thread has real-time scheduling. Known once started; to be said once when it has not.
  virtual bool realtime() const noexcept = 0;
};

}  // namespace hedgehog::control
