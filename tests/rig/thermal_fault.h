// SPDX-License-Identifier: MIT
// Balls that break while they are used: the faults of measurement and of the ball itself that no
// layer may take for a cool winding.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "daemon/device/simulator/simulator_error.h"
#include "tests/rig/thermal_ball.h"

namespace hedgehog::rig {

struct ThermalFault {
  device::SimulatorError error;
  /// It begins when the winding is this warm; below the room: at the start.
  double from_c = -1.0;
  /// What is asked of the winding all the time, A; or random play instead.
  int winding = 1;
  double asked_a = 15.0;
  bool play = false;
  double ambient_c = 25.0;
  double minutes = 10.0;
};

/// The fault on this wiring: with one thermistor only that one can be wrong.
ThermalFault on(ThermalFault fault, const device::FrontEndChoice& front_end) noexcept;

/// Each kind on each winding, in both directions, sudden and growing, cold and warm, at several
/// currents: made by hand.
std::vector<ThermalFault> thermal_faults(const device::FrontEndChoice& front_end);

/// The ball that matches its device file, in the fault's room.
ThermalBallOptions matching_ball(const ThermalFault& fault,
                                 const device::FrontEndChoice& front_end) noexcept;

/// A kind and a value of its range, on a ball of the family.
struct RandomFault {
  ThermalFault fault;
  ThermalBallOptions ball;
};
/// From what random faults are drawn, evenly: each kind, its values, all windings; a third of them
/// from the start, the others at 5 K above the room to 60 C; half of them growing over 10 s to 15
/// minutes; 5 to 15 A, or, a third of them, random play.
struct FaultRange {
  device::SimulatorErrorKind kind;
  double min;
  double max;
};
const std::vector<FaultRange>& fault_ranges();
RandomFault random_fault(std::uint64_t seed, const device::FrontEndChoice& front_end,
                         double thermal_tolerance);

/// It makes a winding seem cooler than it is, or heats what is measured as before: the dangerous
/// direction. Those of the other one feign heat.
bool hides_heat(const device::SimulatorError& error) noexcept;

/// "current_gain 1.10 on winding y, growing over 120 s from 45 C, 15 A asked".
std::string words(const ThermalFault& fault);

}  // namespace hedgehog::rig
