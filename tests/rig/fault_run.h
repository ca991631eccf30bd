// SPDX-License-Identifier: MIT
// A ball that breaks, played until it stops: how hot it gets, and what it says.
#pragma once

#include "tests/rig/thermal_fault.h"

namespace hedgehog::rig {

struct FaultResult {
  double hottest_c = 0.0;
  double above_75_s = 0.0;
  Stop stop;
  /// Of a stuck line of a winding that should be idle: until the bridges slept, ms.
  double driven_ms = 0.0;
};

/// A driven line that should be idle has this long.
inline constexpr double kMaxDrivenMs = 30.0;

/// In steps of 20 ms; a stuck line, which ends within milliseconds, on the whole rig.
FaultResult run_fault(const ThermalFault& fault, const ThermalBallOptions& ball);

/// The stop names what is wrong and, where it is of one winding, that one; or a set of quantities
/// that has it. A ball that did not stop names nothing.
bool named(const ThermalFault& fault, const Stop& stop) noexcept;

}  // namespace hedgehog::rig
