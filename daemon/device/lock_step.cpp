// SPDX-License-Identifier: MIT
#include "daemon/device/lock_step.h"

namespace hedgehog::device {

void LockStep::step() noexcept {
  const LinkFrames frames = link_.step(port_);
  board_.receive(frames.set_point);
  if (frames.other) board_.receive(*frames.other);
  if (const std::optional<Frame> telemetry = board_.step()) link_.receive(*telemetry);
  port_.reports.write(link_.report());
}

}  // namespace hedgehog::device
