// SPDX-License-Identifier: MIT
// Random faults, their ranges, and their text.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/random_stream.h"
#include "tests/rig/thermal_fault.h"

namespace hedgehog::rig {
namespace {

using device::SimulatorErrorKind;

/// A line stuck below this duty drives less than an idle line may.
constexpr double kMinStuckDuty = 0.1;

bool of_thermistor(SimulatorErrorKind kind) noexcept {
  return kind == SimulatorErrorKind::kThermistorOffsetK ||
         kind == SimulatorErrorKind::kThermistorContact;
}

}  // namespace

ThermalFault on(ThermalFault fault, const device::FrontEndChoice& front_end) noexcept {
  const bool one = front_end.parameters().wiring.thermistors < 2;
  if (one && of_thermistor(fault.error.kind))
    fault.error.coil = static_cast<std::uint8_t>(model::ThermalModel{}.sensor_winding);
  return fault;
}

const std::vector<FaultRange>& fault_ranges() {
  static const std::vector<FaultRange> kRanges{
      {SimulatorErrorKind::kCurrentGain, 0.7, 1.3},
      {SimulatorErrorKind::kCurrentOffsetA, -1.0, 1.0},
      {SimulatorErrorKind::kSupplyGain, 0.9, 1.1},
      {SimulatorErrorKind::kResistanceGain, 0.7, 1.2},
      {SimulatorErrorKind::kShortedTurns, 0.02, 0.4},
      {SimulatorErrorKind::kPwmStuck, -1.0, 1.0},
      {SimulatorErrorKind::kThermistorOffsetK, -10.0, 10.0},
      {SimulatorErrorKind::kThermistorContact, 0.2, 1.0},
      {SimulatorErrorKind::kCoolingGain, 0.3, 1.5},
      {SimulatorErrorKind::kHeatCapacityGain, 0.7, 1.3},
      {SimulatorErrorKind::kTachGain, 0.0, 2.0},
  };
  return kRanges;
}

RandomFault random_fault(std::uint64_t seed, const device::FrontEndChoice& front_end,
                         double thermal_tolerance) {
  model::RandomStream random(~seed);
  RandomFault out{{}, family_ball(seed, front_end, thermal_tolerance)};
  ThermalFault& fault = out.fault;
  const FaultRange& range = fault_ranges()[random.bits() % fault_ranges().size()];
  fault.ambient_c = out.ball.board.ambient_c;
  fault.error.kind = range.kind;
  fault.error.value = random.uniform(range.min, range.max);
  fault.winding = static_cast<int>(random.bits() % model::kCoils);
  fault.error.coil = static_cast<std::uint8_t>(fault.winding);
  fault.requested_a = random.uniform(5.0, 15.0);
  fault.play = random.bits() % 3 == 0;
  const double warm_c = random.uniform(fault.ambient_c + 5.0, 60.0);
  fault.from_c = random.bits() % 3 == 0 ? -1.0 : warm_c;
  const double ramp_s = std::exp(random.uniform(std::log(10.0), std::log(900.0)));
  if (random.bits() % 2 == 0) fault.error.ramp_s = ramp_s;
  if (fault.play || fault.error.ramp_s > 0.0) fault.minutes = 20.0;
  if (range.kind == SimulatorErrorKind::kPwmStuck) {
    fault.error.ramp_s = 0.0;
    fault.error.value =
        std::copysign(std::max(kMinStuckDuty, std::abs(fault.error.value)), fault.error.value);
    fault.error.coil = static_cast<std::uint8_t>(random.bits() % model::kCoils);
  }
  fault = on(fault, front_end);
  return out;
}

bool hides_heat(const device::SimulatorError& error) noexcept {
  switch (error.kind) {
    case SimulatorErrorKind::kCurrentGain:
      return error.value > 1.0;
    case SimulatorErrorKind::kCurrentOffsetA:
      return error.value > 0.0;
    case SimulatorErrorKind::kSupplyGain:
    case SimulatorErrorKind::kResistanceGain:
    case SimulatorErrorKind::kCoolingGain:
    case SimulatorErrorKind::kHeatCapacityGain:
      return error.value < 1.0;
    case SimulatorErrorKind::kThermistorOffsetK:
      return error.value < 0.0;
    case SimulatorErrorKind::kTachGain:
      return false;
    case SimulatorErrorKind::kShortedTurns:
    case SimulatorErrorKind::kPwmStuck:
    case SimulatorErrorKind::kThermistorContact:
      break;
  }
  return true;
}

std::string words(const ThermalFault& fault) {
  char text[160];
  std::snprintf(text, sizeof text, "%s %.2f on winding %c, %s from %.0f C, %s %.1f A, room %.0f C",
                std::string(name(fault.error.kind)).c_str(), fault.error.value,
                "xyz"[fault.error.coil], fault.error.ramp_s > 0.0 ? "growing" : "sudden",
                fault.from_c, fault.play ? "random play," : "asked", fault.requested_a,
                fault.ambient_c);
  return text;
}

}  // namespace hedgehog::rig
