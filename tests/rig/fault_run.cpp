// SPDX-License-Identifier: MIT
#include "tests/rig/fault_run.h"

#include <algorithm>

#include "tests/rig/random_play.h"
#include "tests/rig/rig.h"

namespace hedgehog::rig {
namespace {

using control::Quantity;
using control::Reason;
using device::SimulatorErrorKind;

device::SimulatorErrorList errors_of(const ThermalFault& fault) noexcept {
  device::SimulatorErrorList errors;
  errors.generation = 1;
  errors.count = 1;
  errors.error[0] = fault.error;
  return errors;
}

void follow(FaultResult& result, double hottest_c, double dt_s) noexcept {
  result.hottest_c = std::max(result.hottest_c, hottest_c);
  if (hottest_c > 75.0) result.above_75_s += dt_s;
}

/// Plays 15 A along the faulty winding until it has the temperature at which the fault starts, at
/// most a minute.
void warm(Rig& rig, control::EffectId effect, const ThermalFault& fault) {
  model::Vec3 along;
  along[fault.error.coil] = 1.0;
  for (int second = 0; second < 60; ++second) {
    if (rig.plant().heat().winding_c[fault.error.coil] >= fault.from_c) return;
    rig.update(effect, hold(along, 15.0));
    rig.run(1000);
  }
}

FaultResult run_stuck_line(const ThermalFault& fault, const ThermalBallOptions& ball) {
  constexpr int kTicks = 20'000;
  constexpr model::Tick kPlayedBefore = 200;
  RigOptions options;
  options.board = ball.board;
  options.control.uncertainty = ball.uncertainty;
  options.control.start.winding_c.fill(ball.board.start_c);
  options.control.start.core_c = ball.board.start_c;
  options.control.start_ambient_c = ball.board.ambient_c;
  Rig rig(options);
  rig.run_until_armed();
  model::Vec3 along;
  along[fault.winding] = 1.0;
  const auto effect = rig.start(hold(along, fault.requested_a));
  warm(rig, effect, fault);
  rig.update(effect, hold(along, fault.requested_a));
  rig.run(kPlayedBefore);
  rig.board().set_errors(errors_of(fault));
  const bool should_be_idle = fault.error.coil != fault.winding;
  FaultResult result;
  bool driven = true;
  for (int tick = 0; tick < kTicks && rig.controller().state() == control::State::kArmed; ++tick) {
    if (tick % 1000 == 0) rig.update(effect, hold(along, fault.requested_a));
    rig.tick();
    driven = driven && rig.board().core().outputs().awake;
    if (driven && should_be_idle) result.driven_ms += 1.0;
    follow(result, rig.plant().hottest_winding_c(), model::kTickSeconds);
  }
  result.stop = {rig.controller().reason(), rig.controller().last_trip().disagreement};
  return result;
}

FaultResult run_thermal_ball(const ThermalFault& fault, const ThermalBallOptions& options) {
  ThermalBall ball(options);
  bool broken = fault.from_c < 0.0;
  if (broken) ball.set_errors(errors_of(fault));
  RandomPlay play(options.seed);
  model::Vec3 held;
  held[fault.winding] = fault.requested_a;

  FaultResult result;
  const auto steps = static_cast<int>(fault.minutes * 60.0 / ThermalBall::kStepS);
  for (int i = 0; i < steps && !ball.stop().any(); ++i) {
    if (!broken &&
        ball.plant().heat().winding_c[static_cast<std::size_t>(fault.winding)] >= fault.from_c) {
      ball.set_errors(errors_of(fault));
      broken = true;
    }
    if (fault.play) {
      const RandomPlay::RequestedCurrents requested = play.at(i * ThermalBall::kStepS);
      ball.step(requested.peak_a, requested.rms);
    } else {
      ball.step(held);
    }
    follow(result, ball.plant().hottest_winding_c(), ThermalBall::kStepS);
  }
  result.stop = ball.stop();
  return result;
}

/// True if the stop names the thermistor on that winding; the checks of a single thermistor name
/// the sensor's winding.
bool names_thermistor(int coil, const Stop& stop) noexcept {
  if (stop.disagreement.has(Quantity::kThermistor)) return stop.disagreement.coil() == coil;
  return coil == model::ThermalModel{}.sensor_winding &&
         (stop.reason == Reason::kSensorDisagrees || stop.reason == Reason::kSensorFrozen ||
          stop.reason == Reason::kSensorJump);
}

}  // namespace

FaultResult run_fault(const ThermalFault& fault, const ThermalBallOptions& options) {
  return fault.error.kind == SimulatorErrorKind::kPwmStuck ? run_stuck_line(fault, options)
                                                           : run_thermal_ball(fault, options);
}

bool named(const ThermalFault& fault, const Stop& stop) noexcept {
  const control::Disagreement& found = stop.disagreement;
  const int coil = fault.error.coil;
  switch (fault.error.kind) {
    case SimulatorErrorKind::kCurrentGain:
    case SimulatorErrorKind::kCurrentOffsetA:
      return found.has(Quantity::kCurrent) && found.coil() == coil;
    case SimulatorErrorKind::kSupplyGain:
      return found.has(Quantity::kSupplyVoltage);
    case SimulatorErrorKind::kResistanceGain:
    case SimulatorErrorKind::kShortedTurns:
      return found.has(Quantity::kResistance) && found.coil() == coil;
    case SimulatorErrorKind::kThermistorOffsetK:
    case SimulatorErrorKind::kThermistorContact:
      return names_thermistor(coil, stop);
    case SimulatorErrorKind::kCoolingGain:
    case SimulatorErrorKind::kHeatCapacityGain:
      return found.has(Quantity::kHeatBalance);
    case SimulatorErrorKind::kPwmStuck:
      return stop.reason == Reason::kUnexpectedCurrent || stop.reason == Reason::kCurrentMismatch ||
             stop.reason == Reason::kBoardStuckBridge;
    case SimulatorErrorKind::kTachGain:
      return stop.reason == Reason::kFanStopped;
  }
  return false;
}

}  // namespace hedgehog::rig
