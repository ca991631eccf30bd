// SPDX-License-Identifier: MIT
// The control thread in real time: 1 kHz on an absolute clock.
#pragma once

#include <cstdint>

#include "daemon/control/loop/loop.h"

namespace hedgehog::control {

/// SCHED_FIFO if the system allows it. A missed tick is never repeated: the next one gets the
/// number of skipped ticks.
class ControlLoop final : public Loop {
 public:
  ControlLoop(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
              FlightRecorder* recorder)
      : Loop(settings, mailbox, port, recorder) {}
  ~ControlLoop() override { stop(); }

 private:
  bool schedule() noexcept override;
  void run() noexcept override;
  void after_safe_tick() noexcept override;

  /// Due time of the next safe command.
  std::int64_t next_ns_ = 0;
};

}  // namespace hedgehog::control
