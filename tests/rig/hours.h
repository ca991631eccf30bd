// SPDX-License-Identifier: MIT
// An hour of random requests on a random ball: on the thermal law alone in steps of 20 ms, or on
// the whole rig in steps of 1 ms.
#pragma once

#include <cstdint>
#include <string>

#include "daemon/device/simulator/front_end.h"

namespace hedgehog::rig {

struct HourResult {
  /// Empty: all limits were kept.
  std::string failure;
  /// Hottest winding of the plant, C, and the share of the hour in which heat reduced effects.
  double hottest_c = 0.0;
  /// Maximum of the plant's skin temperature, in total and after 10 minutes, C.
  double skin_c = 0.0;
  double held_skin_c = 0.0;
  double derated = 0.0;
  std::uint64_t effects = 0;
  /// Duration played, s.
  double seconds = 0.0;
};

/// Maximum winding temperature in any of the hours, C.
inline constexpr double kHottestAllowedC = 73.5;
/// Maximum skin temperature, in total and after `kHeldAfterS` seconds.
inline constexpr double kSkinAllowedC = 48.0;
inline constexpr double kHeldSkinAllowedC = 43.0;
inline constexpr double kHeldAfterS = 600.0;

/// Adds the skin temperature at `now_s`; returns an empty string, or which limit it exceeds.
std::string follow_skin(HourResult& result, double skin_c, double now_s);

/// A ball of the family (thermal_ball.h) in steps of 20 ms. `seconds` of device time; equal seeds
/// give equal hours. `hand`: factor of the thermal resistance to ambient (2: in a closed hand).
HourResult thermal_hour(std::uint64_t seed, double seconds = 3600.0,
                        const device::FrontEndChoice& front_end = {},
                        double thermal_tolerance = 0.2, double hand = 1.0);

/// The same after `calibrate --thermal` of that ball.
HourResult calibrated_hour(std::uint64_t seed, double seconds = 3600.0,
                           const device::FrontEndChoice& front_end = {});

/// Controller, link and simulated board with this front end. Also checks that no coil is driven
/// once the last effect has ended.
HourResult full_hour(std::uint64_t seed, double seconds = 3600.0,
                     const device::FrontEndChoice& front_end = {}, double hand = 1.0);

}  // namespace hedgehog::rig
