// SPDX-License-Identifier: MIT
// A ball with a fault, played until it stops: its temperatures, and the reported reason.
#pragma once

#include "tests/rig/thermal_fault.h"

namespace hedgehog::rig {

struct FaultResult {
  double hottest_c = 0.0;
  double above_75_s = 0.0;
  Stop stop;
  /// For a stuck line of a winding that should be idle: time until the bridges were asleep, ms.
  double driven_ms = 0.0;
};

/// Maximum time for which a line that should be idle may be driven.
inline constexpr double kMaxDrivenMs = 30.0;

/// Runs in steps of 20 ms; a stuck line, which is stopped within milliseconds, on the whole rig.
FaultResult run_fault(const ThermalFault& fault, const ThermalBallOptions& ball);

/// True if the stop names the fault and, for a fault of one winding, that winding; or a set of
/// quantities that includes it. False for a ball that did not stop.
bool named(const ThermalFault& fault, const Stop& stop) noexcept;

}  // namespace hedgehog::rig
