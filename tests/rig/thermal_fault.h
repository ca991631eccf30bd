// SPDX-License-Identifier: MIT
// Balls that fail in use: faults of the measurements and of the ball itself that no layer may
// mistake for a cool winding.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "daemon/device/simulator/simulator_error.h"
#include "tests/rig/thermal_ball.h"

namespace hedgehog::rig {

struct ThermalFault {
  device::SimulatorError error;
  /// The fault starts when the winding reaches this temperature; below ambient: at the start.
  double from_c = -1.0;
  /// The current requested for the winding throughout, A; or random play instead.
  int winding = 1;
  double requested_a = 15.0;
  bool play = false;
  double ambient_c = 25.0;
  double minutes = 10.0;
};

/// Adapts the fault to this wiring: with one thermistor only that one can be wrong.
ThermalFault on(ThermalFault fault, const device::FrontEndChoice& front_end) noexcept;

/// Manually chosen faults: each kind on each winding, in both directions, sudden and growing, cold
/// and warm, at several currents.
std::vector<ThermalFault> thermal_faults(const device::FrontEndChoice& front_end);

/// A ball that matches its device file, at the fault's ambient temperature.
ThermalBallOptions matching_ball(const ThermalFault& fault,
                                 const device::FrontEndChoice& front_end) noexcept;

/// A fault of random kind and value, on a ball of the family.
struct RandomFault {
  ThermalFault fault;
  ThermalBallOptions ball;
};
/// The ranges from which random faults are drawn, with equal probability: each kind, its values,
/// all windings; a third of them from the start, the others at 5 K above ambient to 60 C; half of
/// them growing over 10 s to 15 minutes; 5 to 15 A, or, for a third of them, random play.
struct FaultRange {
  device::SimulatorErrorKind kind;
  double min;
  double max;
};
const std::vector<FaultRange>& fault_ranges();
RandomFault random_fault(std::uint64_t seed, const device::FrontEndChoice& front_end,
                         double thermal_tolerance);

/// True if the fault makes a winding seem cooler than it is, or heats it without a change in the
/// measurements: the dangerous direction. The others simulate heat.
bool hides_heat(const device::SimulatorError& error) noexcept;

/// "current_gain 1.10 on winding y, growing over 120 s from 45 C, 15 A asked".
std::string words(const ThermalFault& fault);

}  // namespace hedgehog::rig
