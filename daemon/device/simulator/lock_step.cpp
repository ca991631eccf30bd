// SPDX-License-Identifier: MIT
#include "daemon/device/simulator/lock_step.h"

#include "daemon/device/tick_clock.h"

namespace hedgehog::device {

void LockStep::step() noexcept {
  const LinkFrames frames = link_.step(port_);
  board_.receive(frames.set_point);
  link_.set_written(monotonic_ns());
  if (frames.other) board_.receive(*frames.other);
  if (const std::optional<Frame> telemetry = board_.step()) link_.receive(*telemetry);
  if (const std::optional<Frame> truth = board_.truth_frame()) link_.receive(*truth);
  port_.reports.write(link_.report());
  if (link_.truth().known) port_.truth.write(link_.truth());
}

}  // namespace hedgehog::device
