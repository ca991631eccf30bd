// SPDX-License-Identifier: MIT
// Exchange between the control thread and the link: the latest set-point, the latest telemetry,
// and, with the simulated board only, its settings and true state.
#pragma once

#include <cstdint>

#include "base/triple_buffer.h"
#include "daemon/device/board_codec.h"
#include "daemon/device/board_io.h"
#include "daemon/device/simulator/simulator_settings.h"

namespace hedgehog::device {

/// control -> link, one per tick. `count` increases with each: the link detects a fresh set-point.
struct LinkCommand {
  std::uint64_t count = 0;
  BoardCommand board;
};

/// link -> control.
struct LinkReport {
  bool present = false;  // a board of this protocol version is connected
  BoardTelemetry telemetry;
  std::uint64_t telemetry_count = 0;  // incremented with each valid frame
  LinkCounters counters;
  std::uint64_t written_count = 0;  // LinkCommand::count of the newest set-point written
  std::int64_t written_ns = 0;      // time of its first write, CLOCK_MONOTONIC; 0: none yet
};

struct LinkPort {
  base::TripleBuffer<LinkCommand> commands;
  base::TripleBuffer<LinkReport> reports;
  base::TripleBuffer<SimulatorSettings> simulator;  // io -> link; simulated board only
  base::TripleBuffer<PlantTruth> truth;             // link -> io; simulated board only
  base::TripleBuffer<BoardLimits> limits;           // io -> link: at the start, and when tightened
};

}  // namespace hedgehog::device
