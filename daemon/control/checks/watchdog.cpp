// SPDX-License-Identifier: MIT
#include "daemon/control/checks/watchdog.h"

#include <algorithm>

namespace hedgehog::control {
namespace {

using model::kTickSeconds;

// Validity time of a set-point, and therefore of a response to it.
constexpr double kLongestStepS = 0.02;

bool is_active(const device::BoardTelemetry& board) noexcept {
  return board.mode == device::BoardMode::kReady || board.mode == device::BoardMode::kDriving;
}

bool is_possible(double sensor_c) noexcept {
  return sensor_c >= ThermistorCheck::kLowestC && sensor_c < ThermistorCheck::kHighestC;
}

model::ThermistorReadings readable(const device::BoardTelemetry& board,
                                   int sensor_winding) noexcept {
  model::ThermistorReadings readings;
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const auto i = static_cast<std::size_t>(coil);
    if (board.thermistors < 2 && coil != sensor_winding) continue;
    const device::Thermistor one = thermistor_on(board, coil);
    readings.celsius[i] = one.celsius;
    readings.valid[i] = one.state == device::ThermistorState::kRead && is_possible(one.celsius);
  }
  return readings;
}

// These reasons stop the ball in every state; the others only an armed one.
bool stops_unarmed(Reason reason) noexcept {
  return reason == Reason::kUnexpectedCurrent || reason == Reason::kOverheated ||
         reason == Reason::kBoardStuckBridge;
}

}  // namespace

Watchdog::Watchdog(const model::CoilModel& coils, const model::ThermalModel& thermal,
                   device::ThermometerRole thermometer) noexcept
    : sensor_winding_(thermal.sensor_winding),
      supply_(coils.supply_v),
      heat_(coils, thermal),
      current_(coils),
      fan_(thermal.fan_full_rpm),
      thermometer_(thermometer) {}

SensorReading Watchdog::sensor_reading(const WatchdogInputs& in, int coil,
                                       double since_s) const noexcept {
  const device::BoardTelemetry& board = in.board;
  const device::Thermistor thermistor = thermistor_on(board, coil);
  const bool read = thermistor.state == device::ThermistorState::kRead;
  SensorReading reading;
  reading.fresh = in.fresh && thermistor.state != device::ThermistorState::kNone;
  reading.since_s = since_s;
  reading.sensor_c = thermistor.celsius;
  // A latched board still reports a wire that was broken; the reading shows whether it still is.
  // The board does not report whose wire.
  const bool live = coil == sensor_winding_ && (board.mode != device::BoardMode::kLatched ||
                                                !read || !is_possible(reading.sensor_c));
  reading.open = (live && (board.faults & board::kSensorOpen) != 0) ||
                 thermistor.state == device::ThermistorState::kOpen;
  reading.shorted = (live && (board.faults & board::kSensorShort) != 0) ||
                    thermistor.state == device::ThermistorState::kShorted;
  reading.conversions = board.sensor_conversions;
  // The temperature of a winding known by the device file only would jump when it is referenced.
  reading.measuring = heat_.measuring(coil) && heat_.referenced(coil);
  reading.winding_c = heat_.winding_c(coil);
  if (reading.measuring) {
    reading.winding_bias_k = heat_.bias_k(coil);
    reading.winding_error_k = heat_.noise_k(coil) + reading.winding_bias_k;
  }
  return reading;
}

HeatReading Watchdog::heat_reading(const WatchdogInputs& in, double since_s) const noexcept {
  HeatReading reading;
  reading.electrical = in.pair.electrical();
  reading.voltage_v = in.pair.voltage_v();
  reading.before_a = in.pair.before_a();
  reading.after_a = in.pair.after_a();
  reading.measured = in.pair.informative();
  reading.accuracy = in.board.accuracy;
  reading.thermistors = thermistors_;
  reading.fresh = in.fresh;
  reading.since_s = since_s;
  return reading;
}

CurrentReading Watchdog::current_reading(const WatchdogInputs& in, double since_s) const noexcept {
  CurrentReading reading;
  reading.fresh = in.pair.fresh();
  reading.since_s = since_s;
  reading.skipped = in.ticks - 1;
  reading.follows = in.pair.follows();
  reading.current_a = in.pair.after_a();
  reading.measured = in.pair.after_measured();
  reading.applied_v = in.pair.voltage_v();
  if (in.commanded.enable() && is_active(in.board)) {
    reading.commanded_v = in.board.supply_v * in.commanded.first_duty();
    reading.held_v = in.board.supply_v * in.commanded.duty();
  }
  return reading;
}

Disagreement Watchdog::check_supply(const WatchdogInputs& in, double dt_s) noexcept {
  const device::Measured& measured = in.pair.measured();
  SupplyReading reading;
  reading.known = in.pair.electrical() && in.board.supply_current_known && measured[0] &&
                  measured[1] && measured[2];
  reading.duty = in.board.duty;
  // The supply does not absorb the current that braking bridges return.
  reading.current_a = 0.5 * (in.pair.before_a() + in.pair.after_a());
  reading.known = reading.known && dot(reading.duty, reading.current_a) > 0.0;
  reading.supply_current_a = in.board.supply_current_a;
  reading.supply_v = in.board.supply_v;
  reading.accuracy = in.board.accuracy;
  return supply_.step(reading, dt_s);
}

Disagreement Watchdog::check_other_thermistors(const WatchdogInputs& in, double since_s,
                                               double dt_s) noexcept {
  Disagreement found;
  thermistor_count_ = std::min(in.board.thermistors, model::kCoils);
  if (thermistor_count_ < 2) return found;
  for (int coil = 0; coil < thermistor_count_; ++coil) {
    if (coil == sensor_winding_) continue;
    ThermistorCheck& check = thermistor_checks_[static_cast<std::size_t>(coil)];
    Reason reason = check.step(sensor_reading(in, coil, since_s), dt_s);
    // Also one that the board no longer sends.
    if (in.fresh && check.age_s() >= ThermistorCheck::kStaleAfterS) reason = Reason::kSensorStale;
    if (!found.any()) found = disagreement_of(coil, reason);
  }
  return found;
}

Reason Watchdog::step(const WatchdogInputs& in) noexcept {
  const device::BoardTelemetry& board = in.board;
  board_.step(in.board_present, in.fresh, board, in.ticks);
  // Telemetry from before a gap is no evidence about the gap.
  const double dt_s = std::min(kTickSeconds * static_cast<double>(in.ticks), kLongestStepS);
  since_fresh_s_ = std::min(since_fresh_s_ + dt_s, kLongestStepS);
  const double since_s = since_fresh_s_;
  if (in.fresh) since_fresh_s_ = 0.0;

  thermistors_ = readable(board, sensor_winding_);
  const SensorReading thermistor = sensor_reading(in, sensor_winding_, since_s);
  const auto own = static_cast<std::size_t>(sensor_winding_);
  const Reason sensor_fault = thermistor_checks_[own].step(thermistor, dt_s);
  thermistors_.valid[own] = !thermistor.open && !thermistor.shorted && thermistors_.valid[own];
  const Reason heat = heat_.step(heat_reading(in, since_s), in.trip_c, dt_s);
  const Reason current = current_.step(current_reading(in, since_s));
  const Disagreement thermistors = check_other_thermistors(in, since_s, dt_s);
  const Disagreement supply = check_supply(in, dt_s);
  const Disagreement disagreement = thermistors.any() ? thermistors : supply;
  if (disagreement.any()) disagreement_ = disagreement;
  fan_.follow({in.fresh, board.fan_duty, board.fan_rpm}, in.fresh ? since_s : dt_s);
  const Reason fan =
      in.fresh ? fan_.step(in.commanded.fan > 0, board.fan_rpm, since_s) : Reason::kNone;
  const Reason thermometer = thermometer_.step(
      {in.thermometer, in.now, sensor().usable(), thermistor.sensor_c, in.trip_c}, dt_s);

  // The cause before its consequences: a broken bridge also causes a wrong current.
  const std::array found{board_.fault(),
                         sensor_fault,
                         heat,
                         current,
                         disagreement.any() ? Reason::kMeasurementsDisagree : Reason::kNone,
                         fan,
                         thermometer};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Reason reason = found[i];
    // A board keeps its latch until it is armed.
    const bool latch = i == 0 && in.arming;
    if (reason != Reason::kNone && !latch && (in.armed || stops_unarmed(reason))) return reason;
  }
  return Reason::kNone;
}

Reason Watchdog::arming_blocker() const noexcept {
  if (!board_.alive()) return Reason::kNoBoard;
  if (sensor().arming_blocker() != Reason::kNone) return sensor().arming_blocker();
  for (int coil = 0; coil < thermistor_count_ && thermistor_count_ > 1; ++coil) {
    const Reason blocker = thermistor_checks_[static_cast<std::size_t>(coil)].arming_blocker();
    if (blocker != Reason::kNone) return blocker;
  }
  if (current_.pending()) return Reason::kUnexpectedCurrent;
  return thermometer_.arming_blocker();
}

}  // namespace hedgehog::control
