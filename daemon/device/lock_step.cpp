// SPDX-License-Identifier: MIT
#include "daemon/device/lock_step.h"

namespace hedgehog::device {

void LockStep::step() noexcept {
  const BoardLimits& limits = port_.limits.read();
  if (port_.limits.was_fresh()) link_.set_limits(limits);
  const LinkCommand& command = port_.commands.read();
  const SimulatorSettings& simulator = port_.simulator.read();
  simulator_known_ = simulator_known_ || port_.simulator.was_fresh();
  const LinkFrames frames = simulator_known_ ? link_.step(command, simulator) : link_.step(command);
  board_.receive(frames.set_point);
  if (frames.other) board_.receive(*frames.other);
  if (const std::optional<Frame> telemetry = board_.step()) link_.receive(*telemetry);
  port_.reports.write(link_.report());
}

}  // namespace hedgehog::device
