// SPDX-License-Identifier: MIT
#include "tests/rig/thermal_faults.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/rig/random_play.h"

namespace hedgehog::rig {
namespace {

using control::Quantity;
using control::Reason;
using device::SimulatorErrorKind;

constexpr int kY = 1;

class FaultList {
 public:
  void add(SimulatorErrorKind kind, int coil, double value, double ramp_s, double from_c,
           double asked_a, double ambient_c = 25.0, double minutes = 10.0) {
    ThermalFault fault;
    fault.error = {kind, static_cast<std::uint8_t>(coil), value, ramp_s};
    fault.from_c = from_c;
    fault.winding = coil;
    fault.asked_a = asked_a;
    fault.ambient_c = ambient_c;
    fault.minutes = minutes;
    faults_.push_back(fault);
  }
  std::vector<ThermalFault> take() { return std::move(faults_); }

 private:
  std::vector<ThermalFault> faults_;
};

void add_resistances(FaultList& list) {
  for (const double gain : {0.97, 0.95, 0.93, 0.92, 0.90}) {
    for (const double ambient_c : {25.0, 32.0, 40.0})
      for (const double a : {8.0, 12.0, 15.0})
        list.add(SimulatorErrorKind::kResistanceGain, kY, gain, 0, -1, a, ambient_c, 6);
  }
  for (const double gain : {0.97, 0.95, 0.9, 0.85, 0.8, 0.7})
    for (const double a : {8.0, 15.0})
      list.add(SimulatorErrorKind::kResistanceGain, kY, gain, 0, 58, a);
  for (const double ramp_s : {30.0, 120.0, 600.0}) {
    for (const double share : {0.05, 0.1, 0.2, 0.4}) {
      for (const double a : {6.0, 8.0, 15.0})
        list.add(SimulatorErrorKind::kShortedTurns, kY, share, ramp_s, 45, a, 25,
                 ramp_s > 300 ? 20 : 12);
    }
  }
}

void add_currents(FaultList& list) {
  for (const double gain : {1.03, 1.05, 1.1, 1.2, 1.3}) {
    for (const double a : {8.0, 15.0}) {
      list.add(SimulatorErrorKind::kCurrentGain, kY, gain, 0, 58, a);
      list.add(SimulatorErrorKind::kCurrentGain, kY, gain, 120, 45, a);
      list.add(SimulatorErrorKind::kCurrentGain, kY, gain, 0, -1, a);
    }
  }
  for (const double offset_a : {0.3, 0.5, 1.0}) {
    for (const double a : {5.0, 8.0, 15.0}) {
      list.add(SimulatorErrorKind::kCurrentOffsetA, kY, offset_a, 0, 33, a, 25, 15);
      list.add(SimulatorErrorKind::kCurrentOffsetA, kY, offset_a, 120, 33, a, 25, 15);
    }
  }
  for (const double gain : {0.97, 0.95, 0.93, 0.9}) {
    for (const int coil : {0, 1}) {
      for (const double a : {8.0, 15.0}) {
        list.add(SimulatorErrorKind::kSupplyGain, coil, gain, 0, -1, a);
        list.add(SimulatorErrorKind::kSupplyGain, coil, gain, 0, 50, a);
        list.add(SimulatorErrorKind::kSupplyGain, coil, gain, 120, 45, a);
      }
    }
  }
}

void add_thermistors(FaultList& list) {
  for (const double offset_k : {-3.0, -6.0, -10.0}) {
    for (const int coil : {0, 1}) {
      list.add(SimulatorErrorKind::kThermistorOffsetK, coil, offset_k, 0, 50, 15);
      list.add(SimulatorErrorKind::kThermistorOffsetK, coil, offset_k, 300, 40, 15);
    }
  }
  for (const double share : {0.3, 0.6, 1.0}) {
    for (const int coil : {0, 1}) {
      list.add(SimulatorErrorKind::kThermistorContact, coil, share, 0, -1, 15);
      list.add(SimulatorErrorKind::kThermistorContact, coil, share, 120, 45, 15);
    }
  }
}

void add_thermal(FaultList& list) {
  for (const double gain : {0.5, 0.3}) {
    for (const int coil : {0, 1})
      for (const double a : {6.0, 15.0})
        list.add(SimulatorErrorKind::kCoolingGain, coil, gain, 0, 45, a, 25, 20);
  }
  for (const double gain : {0.8, 0.7})
    for (const int coil : {0, 1})
      list.add(SimulatorErrorKind::kHeatCapacityGain, coil, gain, 0, -1, 15);
}

bool of_thermistor(SimulatorErrorKind kind) noexcept {
  return kind == SimulatorErrorKind::kThermistorOffsetK ||
         kind == SimulatorErrorKind::kThermistorContact;
}

}  // namespace

std::vector<ThermalFault> thermal_faults() {
  FaultList list;
  add_resistances(list);
  add_currents(list);
  add_thermistors(list);
  add_thermal(list);
  return list.take();
}

RandomFault random_fault(std::uint64_t seed, const device::FrontEndChoice& front_end,
                         double thermal_tolerance) {
  static const std::vector<ThermalFault> kFaults = thermal_faults();
  model::RandomStream random(~seed);
  RandomFault out{kFaults[random.bits() % kFaults.size()],
                  family_ball(seed, front_end, thermal_tolerance)};
  ThermalFault& fault = out.fault;
  fault.ambient_c = out.ball.board.ambient_c;
  fault.asked_a = std::max(5.0, fault.asked_a * random.uniform(0.7, 1.0));
  if (fault.error.ramp_s > 0.0) {
    fault.error.ramp_s = std::exp(random.uniform(std::log(10.0), std::log(900.0)));
    fault.minutes = 20.0;
  }
  if (fault.from_c > 0.0) fault.from_c = random.uniform(fault.ambient_c + 5.0, 60.0);
  fault.winding = static_cast<int>(random.bits() % model::kCoils);
  fault.error.coil = static_cast<std::uint8_t>(fault.winding);
  fault.play = random.bits() % 3 == 0;
  if (fault.play) fault.minutes = 20.0;
  return out;
}

ThermalBallOptions matching_ball(const ThermalFault& fault,
                                 const device::FrontEndChoice& front_end) noexcept {
  ThermalBallOptions options;
  options.board.front_end = front_end;
  options.board.ambient_c = options.board.start_c = fault.ambient_c;
  return options;
}

FaultResult run_fault(const ThermalFault& fault, const ThermalBallOptions& options) {
  ThermalBall ball(options);
  device::SimulatorErrorList errors;
  errors.generation = 1;
  errors.count = 1;
  errors.error[0] = fault.error;
  // With one thermistor only that one can be wrong.
  const bool only = options.board.front_end.parameters().wiring.thermistors < 2;
  if (only && of_thermistor(fault.error.kind)) errors.error[0].coil = 0;
  bool broken = fault.from_c < 0.0;
  if (broken) ball.set_errors(errors);
  RandomPlay play(options.seed);
  model::Vec3 held;
  held[fault.winding] = fault.asked_a;

  FaultResult result;
  const auto steps = static_cast<int>(fault.minutes * 60.0 / ThermalBall::kStepS);
  for (int i = 0; i < steps && !ball.stop().any(); ++i) {
    if (!broken &&
        ball.plant().heat().winding_c[static_cast<std::size_t>(fault.winding)] >= fault.from_c) {
      ball.set_errors(errors);
      broken = true;
    }
    if (fault.play) {
      const RandomPlay::Asked asked = play.at(i * ThermalBall::kStepS);
      ball.step(asked.peak_a, asked.rms);
    } else {
      ball.step(held);
    }
    const double hottest_c = ball.plant().hottest_winding_c();
    result.hottest_c = std::max(result.hottest_c, hottest_c);
    if (hottest_c > 75.0) result.above_75_s += ThermalBall::kStepS;
  }
  result.stop = ball.stop();
  return result;
}

std::string words(const ThermalFault& fault) {
  char text[160];
  std::snprintf(text, sizeof text, "%s %.2f on winding %c, %s from %.0f C, %s %.1f A, room %.0f C",
                std::string(name(fault.error.kind)).c_str(), fault.error.value,
                "xyz"[fault.error.coil], fault.error.ramp_s > 0.0 ? "growing" : "sudden",
                fault.from_c, fault.play ? "random play," : "asked", fault.asked_a,
                fault.ambient_c);
  return text;
}

bool named(const ThermalFault& fault, const Stop& stop) noexcept {
  const control::Disagreement& found = stop.disagreement;
  switch (fault.error.kind) {
    case SimulatorErrorKind::kCurrentGain:
    case SimulatorErrorKind::kCurrentOffsetA:
      return found.has(Quantity::kCurrent) && found.coil() == fault.error.coil;
    case SimulatorErrorKind::kSupplyGain:
      return found.has(Quantity::kSupplyVoltage);
    case SimulatorErrorKind::kResistanceGain:
    case SimulatorErrorKind::kShortedTurns:
      return found.has(Quantity::kResistance) && found.coil() == fault.error.coil;
    case SimulatorErrorKind::kThermistorOffsetK:
    case SimulatorErrorKind::kThermistorContact:
      return found.has(Quantity::kThermistor) || stop.reason == Reason::kSensorDisagrees ||
             stop.reason == Reason::kSensorFrozen || stop.reason == Reason::kSensorJump;
    case SimulatorErrorKind::kCoolingGain:
    case SimulatorErrorKind::kHeatCapacityGain:
      return found.has(Quantity::kHeatBalance);
    case SimulatorErrorKind::kPwmStuck:
    case SimulatorErrorKind::kTachGain:
      break;
  }
  return false;
}

}  // namespace hedgehog::rig
