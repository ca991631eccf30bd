// SPDX-License-Identifier: MIT
#include "daemon/control/watchdog.h"

#include <array>

namespace hedgehog::control {
namespace {

using model::kTickSeconds;

bool obeys(const device::BoardTelemetry& board) noexcept {
  return board.mode == device::BoardMode::kReady || board.mode == device::BoardMode::kDriving;
}

bool is_possible(double sensor_c) noexcept {
  return sensor_c >= SensorCheck::kLowestC && sensor_c <= SensorCheck::kHighestC;
}

}  // namespace

Watchdog::Watchdog(const model::CoilModel& coils, int sensor_winding) noexcept
    : sensor_winding_(sensor_winding), heat_(coils), current_(coils) {}

Reason Watchdog::step(const WatchdogInputs& in) noexcept {
  const device::BoardTelemetry& board = in.board;
  board_.step(in.board_present, in.fresh, board, in.ticks);

  SensorReading reading;
  reading.fresh = in.fresh;
  reading.sensor_c = board.sensor_c;
  // A latched board also tells of a wire that was broken; whether it still is, the reading shows.
  const bool live = board.mode != device::BoardMode::kLatched || !is_possible(board.sensor_c);
  reading.open = live && (board.faults & device::kFaultSensorOpen) != 0;
  reading.shorted = live && (board.faults & device::kFaultSensorShort) != 0;
  reading.conversions = board.sensor_conversions;
  reading.measuring = heat_.measuring(sensor_winding_);
  reading.winding_c = heat_.winding_c(sensor_winding_);
  const Reason sensor = sensor_.step(reading, kTickSeconds);

  const bool readable =
      in.fresh && !reading.open && !reading.shorted && board.sensor_c <= SensorCheck::kHighestC;
  const Reason heat = heat_.step({in.pair.electrical(), in.pair.voltage_v(), in.pair.before_a(),
                                  in.pair.after_a(), readable, board.sensor_c},
                                 in.trip_c, kTickSeconds);

  CurrentReading currents;
  currents.consecutive = in.pair.consecutive();
  currents.current_a = in.pair.after_a();
  currents.applied_v = in.pair.voltage_v();
  if (in.commanded.enable() && obeys(board)) {
    currents.commanded_v = board.supply_v * in.commanded.first_duty();
  }
  const Reason current = current_.step(currents);
  const Reason fan =
      in.fresh ? fan_.step(in.commanded.fan / 255.0, board.fan_rpm, kTickSeconds) : Reason::kNone;

  // The cause before its consequences: a broken bridge also shows as a wrong current.
  const std::array<Reason, 5> found{board_.fault(), sensor, heat, current, fan};
  for (const Reason reason : found) {
    if (reason != Reason::kNone) return reason;
  }
  return Reason::kNone;
}

Reason Watchdog::doubt() const noexcept {
  if (!board_.alive()) return Reason::kNoBoard;
  if (sensor_.doubt() != Reason::kNone) return sensor_.doubt();
  if (current_.suspicious()) return Reason::kUnexpectedCurrent;
  return Reason::kNone;
}

}  // namespace hedgehog::control
