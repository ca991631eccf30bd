// SPDX-License-Identifier: MIT
// Exchange between the control thread and the link: the latest set-point down, the latest telemetry
// up, and, with the simulated board only, the settings of the simulated world.
#pragma once

#include <cstdint>

#include "base/triple_buffer.h"
#include "daemon/device/board_codec.h"
#include "daemon/device/board_io.h"
#include "daemon/device/simulator/simulator_settings.h"

namespace hedgehog::device {

/// control -> link, one a tick. `count` rises with each, so that the link can tell a fresh
/// set-point from an old one.
struct LinkCommand {
  std::uint64_t count = 0;
  BoardCommand board;
};

/// link -> control.
struct LinkReport {
  /// A board is connected and speaks our protocol version.
  bool present = false;
  /// The last telemetry; `telemetry_count` rises with each valid frame.
  BoardTelemetry telemetry;
  std::uint64_t telemetry_count = 0;
  LinkCounters counters;
  /// The newest set-point that was written to the board, by LinkCommand::count, and when it first
  /// was, CLOCK_MONOTONIC; 0: none yet.
  std::uint64_t written_count = 0;
  std::int64_t written_ns = 0;
};

struct LinkPort {
  base::TripleBuffer<LinkCommand> commands;
  base::TripleBuffer<LinkReport> reports;
  /// io -> link; used by the simulated board only.
  base::TripleBuffer<SimulatorSettings> simulator;
  /// link -> io; of the simulated board only.
  base::TripleBuffer<PlantTruth> truth;
  /// io -> link: at the start, and when they became tighter.
  base::TripleBuffer<BoardLimits> limits;
};

}  // namespace hedgehog::device
