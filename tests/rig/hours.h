// SPDX-License-Identifier: MIT
// An hour of random requests on a random ball (DESIGN section 6, "Limiter"): on the thermal law
// alone in steps of 20 ms, or on the whole rig in steps of 1 ms.
#pragma once

#include <cstdint>
#include <string>

namespace hedgehog::rig {

struct HourResult {
  /// Empty: everything held.
  std::string failure;
  /// Hottest winding of the plant, C, and the share of the hour in which heat reduced effects.
  double hottest_c = 0.0;
  double derated = 0.0;
  std::uint64_t effects = 0;
};

/// A winding may not get hotter than this in any of the hours, C.
inline constexpr double kHottestAllowedC = 73.5;

/// Observer, limiter, the watchdog's thermistor and heat checks and the fan, fed with mean-square
/// currents. `seconds` of device time; equal seeds give equal hours.
HourResult thermal_hour(std::uint64_t seed, double seconds = 3600.0);

/// Controller, link and simulated board. Also checks that no coil is driven once the last effect
/// has ended.
HourResult full_hour(std::uint64_t seed, double seconds = 3600.0);

}  // namespace hedgehog::rig
