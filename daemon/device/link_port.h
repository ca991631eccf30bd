// SPDX-License-Identifier: MIT
// Exchange between the control thread and the link: the latest set-point, the latest telemetry,
// and, with the simulated board only, its settings.
#pragma once

#include <cstdint>

#include "base/triple_buffer.h"
#include "daemon/device/board_codec.h"
#include "daemon/device/board_io.h"
#include "daemon/device/simulator/simulator_settings.h"

namespace hedgehog::device {

/// control -> link, one per tick. `count` is incremented with each, so that the link can
/// distinguish a fresh set-point from an old one.
struct LinkCommand {
  std::uint64_t count = 0;
  BoardCommand board;
};

/// link -> control.
struct LinkReport {
  /// A board of this protocol version is connected.
  bool present = false;
  /// The last telemetry; `telemetry_count` is incremented with each valid frame.
  BoardTelemetry telemetry;
  std::uint64_t telemetry_count = 0;
  LinkCounters counters;
  /// LinkCommand::count of the newest set-point written to the board, and the time of its first
  /// write, CLOCK_MONOTONIC; 0: none yet.
  std::uint64_t written_count = 0;
  std::int64_t written_ns = 0;
};

struct LinkPort {
  base::TripleBuffer<LinkCommand> commands;
  base::TripleBuffer<LinkReport> reports;
  /// io -> link; simulated board only.
  base::TripleBuffer<SimulatorSettings> simulator;
  /// link -> io; simulated board only.
  base::TripleBuffer<PlantTruth> truth;
  /// io -> link: at the start, and when the limits were tightened.
  base::TripleBuffer<BoardLimits> limits;
};

}  // namespace hedgehog::device
