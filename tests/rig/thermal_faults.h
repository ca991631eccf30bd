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

struct FaultResult {
  double hottest_c = 0.0;
  double above_75_s = 0.0;
  Stop stop;
};

/// Each kind, sudden and growing, cold and warm, at several currents: made by hand.
std::vector<ThermalFault> thermal_faults();

/// One of those with other numbers, on a ball of the family.
struct RandomFault {
  ThermalFault fault;
  ThermalBallOptions ball;
};
RandomFault random_fault(std::uint64_t seed, const device::FrontEndChoice& front_end,
                         double thermal_tolerance);

/// The ball that matches its device file, in the fault's room.
ThermalBallOptions matching_ball(const ThermalFault& fault,
                                 const device::FrontEndChoice& front_end) noexcept;

FaultResult run_fault(const ThermalFault& fault, const ThermalBallOptions& ball);

/// "current_gain 1.10 on winding y, growing over 120 s from 45 C, 15 A asked".
std::string words(const ThermalFault& fault);
/// The stop names what is wrong, or a set of quantities that has it. A ball that did not stop names
/// nothing.
bool named(const ThermalFault& fault, const Stop& stop) noexcept;

}  // namespace hedgehog::rig
