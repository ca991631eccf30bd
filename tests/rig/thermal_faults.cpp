// SPDX-License-Identifier: MIT
// The manually chosen faults.
#include "daemon/device/simulator/front_end.h"
#include "tests/rig/thermal_fault.h"

namespace hedgehog::rig {
namespace {

using device::SimulatorErrorKind;

constexpr double kCold = -1.0;

class FaultList {
 public:
  void add(SimulatorErrorKind kind, double value, double ramp_s, double from_c, double requested_a,
           double ambient_c = 25.0, double minutes = 10.0) {
    ThermalFault fault;
    fault.error = {kind, static_cast<std::uint8_t>(winding), value, ramp_s};
    fault.from_c = from_c;
    fault.winding = winding;
    fault.requested_a = requested_a;
    fault.ambient_c = ambient_c;
    fault.minutes = minutes;
    faults.push_back(fault);
  }
  /// The winding in use.
  int winding = 0;
  std::vector<ThermalFault> faults;
};

void add_resistances(FaultList& list) {
  for (const double gain : {0.97, 0.95, 0.93, 0.92, 0.90, 1.03, 1.07, 1.10}) {
    for (const double ambient_c : {25.0, 32.0, 40.0})
      for (const double a : {8.0, 12.0, 15.0})
        list.add(SimulatorErrorKind::kResistanceGain, gain, 0, kCold, a, ambient_c, 6);
  }
  for (const double gain : {0.97, 0.95, 0.9, 0.85, 0.8, 0.7, 1.03, 1.05, 1.1, 1.2})
    for (const double a : {8.0, 15.0})
      list.add(SimulatorErrorKind::kResistanceGain, gain, 0, 58, a);
  for (const double gain : {0.9, 1.1})
    list.add(SimulatorErrorKind::kResistanceGain, gain, 120, 45, 15);
  for (const double ramp_s : {30.0, 120.0, 600.0}) {
    for (const double share : {0.05, 0.1, 0.2, 0.4}) {
      for (const double a : {6.0, 8.0, 15.0})
        list.add(SimulatorErrorKind::kShortedTurns, share, ramp_s, 45, a, 25,
                 ramp_s > 300 ? 20 : 12);
    }
  }
  for (const double share : {0.05, 0.2}) {
    list.add(SimulatorErrorKind::kShortedTurns, share, 0, kCold, 15);
    list.add(SimulatorErrorKind::kShortedTurns, share, 0, 58, 15);
  }
}

void add_currents(FaultList& list) {
  for (const double gain : {0.7, 0.8, 0.9, 0.95, 0.97, 1.03, 1.05, 1.1, 1.2, 1.3}) {
    for (const double a : {8.0, 15.0}) {
      list.add(SimulatorErrorKind::kCurrentGain, gain, 0, 58, a);
      list.add(SimulatorErrorKind::kCurrentGain, gain, 120, 45, a);
      list.add(SimulatorErrorKind::kCurrentGain, gain, 0, kCold, a);
    }
  }
  for (const double offset_a : {-1.0, -0.5, -0.3, 0.3, 0.5, 1.0}) {
    for (const double a : {5.0, 8.0, 15.0}) {
      list.add(SimulatorErrorKind::kCurrentOffsetA, offset_a, 0, 33, a, 25, 15);
      list.add(SimulatorErrorKind::kCurrentOffsetA, offset_a, 120, 33, a, 25, 15);
    }
    list.add(SimulatorErrorKind::kCurrentOffsetA, offset_a, 0, kCold, 15);
  }
  for (const double gain : {0.88, 0.9, 0.93, 0.95, 0.97, 1.03, 1.05, 1.07, 1.1}) {
    for (const double a : {8.0, 15.0}) {
      list.add(SimulatorErrorKind::kSupplyGain, gain, 0, kCold, a);
      list.add(SimulatorErrorKind::kSupplyGain, gain, 0, 50, a);
      list.add(SimulatorErrorKind::kSupplyGain, gain, 120, 45, a);
    }
  }
}

void add_thermistors(FaultList& list) {
  for (const double offset_k : {-10.0, -6.0, -3.0, 3.0, 6.0, 10.0}) {
    list.add(SimulatorErrorKind::kThermistorOffsetK, offset_k, 0, kCold, 15);
    list.add(SimulatorErrorKind::kThermistorOffsetK, offset_k, 0, 50, 15);
    list.add(SimulatorErrorKind::kThermistorOffsetK, offset_k, 300, 40, 15);
  }
  for (const double share : {0.3, 0.6, 1.0}) {
    list.add(SimulatorErrorKind::kThermistorContact, share, 0, kCold, 15);
    list.add(SimulatorErrorKind::kThermistorContact, share, 120, 45, 15);
  }
}

void add_thermal(FaultList& list) {
  for (const double gain : {0.25, 0.3, 0.5, 1.5}) {
    for (const double a : {6.0, 15.0})
      list.add(SimulatorErrorKind::kCoolingGain, gain, 0, 45, a, 25, 20);
    list.add(SimulatorErrorKind::kCoolingGain, gain, 300, 45, 15, 25, 20);
  }
  for (const double gain : {0.7, 0.8, 1.2, 1.3})
    list.add(SimulatorErrorKind::kHeatCapacityGain, gain, 0, kCold, 15);
  for (const double gain : {0.0, 0.5, 1.3, 2.0}) {
    list.add(SimulatorErrorKind::kTachGain, gain, 0, 45, 15);
    list.add(SimulatorErrorKind::kTachGain, gain, 120, 45, 15);
  }
}

/// Stuck lines of the next winding, which should be idle, and of the one in use.
void add_stuck_lines(FaultList& list) {
  for (const double duty : {-1.0, -0.3, 0.1, 0.3, 0.5, 1.0}) {
    for (const double from_c : {kCold, 50.0}) {
      list.add(SimulatorErrorKind::kPwmStuck, duty, 0, from_c, 5);
      list.faults.back().error.coil = static_cast<std::uint8_t>((list.winding + 1) % model::kCoils);
      list.add(SimulatorErrorKind::kPwmStuck, duty, 0, from_c, 5);
    }
  }
}

}  // namespace

std::vector<ThermalFault> thermal_faults(const device::FrontEndChoice& front_end) {
  FaultList list;
  for (list.winding = 0; list.winding < model::kCoils; ++list.winding) {
    add_resistances(list);
    add_currents(list);
    add_thermistors(list);
    add_thermal(list);
    add_stuck_lines(list);
  }
  for (ThermalFault& fault : list.faults) fault = on(fault, front_end);
  return std::move(list.faults);
}

ThermalBallOptions matching_ball(const ThermalFault& fault,
                                 const device::FrontEndChoice& front_end) noexcept {
  ThermalBallOptions options;
  options.board.front_end = front_end;
  options.board.ambient_c = options.board.start_c = fault.ambient_c;
  return options;
}

}  // namespace hedgehog::rig
