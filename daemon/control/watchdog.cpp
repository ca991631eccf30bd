// SPDX-License-Identifier: MIT
#include "daemon/control/watchdog.h"

#include <algorithm>
#include <array>

namespace hedgehog::control {
namespace {

using model::kTickSeconds;

// As long as a set-point lasts, and so an answer to it.
constexpr double kLongestStepS = 0.02;

bool obeys(const device::BoardTelemetry& board) noexcept {
  return board.mode == device::BoardMode::kReady || board.mode == device::BoardMode::kDriving;
}

bool is_possible(double sensor_c) noexcept {
  return sensor_c >= SensorCheck::kLowestC && sensor_c <= SensorCheck::kHighestC;
}

// These stop the ball in every state; the others only one that is armed.
bool stops_unarmed(Reason reason) noexcept {
  return reason == Reason::kUnexpectedCurrent || reason == Reason::kOverheated ||
         reason == Reason::kBoardStuckBridge;
}

}  // namespace

Watchdog::Watchdog(const model::CoilModel& coils, int sensor_winding,
                   device::ThermometerRole thermometer) noexcept
    : sensor_winding_(sensor_winding), heat_(coils), current_(coils), thermometer_(thermometer) {}

Reason Watchdog::step(const WatchdogInputs& in) noexcept {
  const device::BoardTelemetry& board = in.board;
  board_.step(in.board_present, in.fresh, board, in.ticks);
  // What was told before a gap says nothing about the gap.
  const double dt_s = std::min(kTickSeconds * static_cast<double>(in.ticks), kLongestStepS);
  unread_s_ = std::min(unread_s_ + dt_s, kLongestStepS);
  const double since_s = unread_s_;
  if (in.fresh) unread_s_ = 0.0;

  SensorReading reading;
  reading.fresh = in.fresh;
  reading.since_s = since_s;
  reading.sensor_c = board.sensor_c;
  // A latched board also tells of a wire that was broken; whether it still is, the reading shows.
  const bool live = board.mode != device::BoardMode::kLatched || !is_possible(board.sensor_c);
  reading.open = live && (board.faults & device::kFaultSensorOpen) != 0;
  reading.shorted = live && (board.faults & device::kFaultSensorShort) != 0;
  reading.conversions = board.sensor_conversions;
  reading.measuring = heat_.measuring(sensor_winding_);
  reading.winding_c = heat_.winding_c(sensor_winding_);
  const Reason sensor = sensor_.step(reading, dt_s);

  const bool readable =
      !reading.open && !reading.shorted && board.sensor_c <= SensorCheck::kHighestC;
  const Reason heat = heat_.step({in.pair.electrical(), in.pair.voltage_v(), in.pair.before_a(),
                                  in.pair.after_a(), readable, board.sensor_c, in.fresh, since_s},
                                 in.trip_c, dt_s);

  CurrentReading currents;
  currents.fresh = in.pair.fresh();
  currents.since_s = since_s;
  currents.skipped = in.ticks - 1;
  currents.follows = in.pair.follows();
  currents.current_a = in.pair.after_a();
  currents.applied_v = in.pair.voltage_v();
  if (in.commanded.enable() && obeys(board)) {
    currents.commanded_v = board.supply_v * in.commanded.first_duty();
    currents.held_v = board.supply_v * in.commanded.duty();
  }
  const Reason current = current_.step(currents);
  const Reason fan =
      in.fresh ? fan_.step(in.commanded.fan / 255.0, board.fan_rpm, since_s) : Reason::kNone;
  const Reason thermometer = thermometer_.step(
      {in.thermometer, in.now, sensor_.usable(), board.sensor_c, in.trip_c}, dt_s);

  // The cause before its consequences: a broken bridge also shows as a wrong current.
  const std::array<Reason, 6> found{board_.fault(), sensor, heat, current, fan, thermometer};
  for (const Reason reason : found) {
    if (reason != Reason::kNone && (in.armed || stops_unarmed(reason))) return reason;
  }
  return Reason::kNone;
}

Reason Watchdog::doubt() const noexcept {
  if (!board_.alive()) return Reason::kNoBoard;
  if (sensor_.doubt() != Reason::kNone) return sensor_.doubt();
  if (current_.suspicious()) return Reason::kUnexpectedCurrent;
  return thermometer_.doubt();
}

}  // namespace hedgehog::control
