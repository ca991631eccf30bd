// SPDX-License-Identifier: MIT
// Force over time as line segments, from base force, ramp and envelope. Pure.
#pragma once

#include <linux/input.h>

#include <cstdint>
#include <vector>

namespace hedgehog::gamepad {

/// Linux' value of full force.
inline constexpr double kFullForce = 0x7fff;

struct ForcePoint {
  std::int64_t t_ms = 0;
  double force = 0.0;  // -1..1; negative: towards the opposite side
  friend bool operator==(const ForcePoint&, const ForcePoint&) = default;
};

/// The force from 0 to `length_ms` (>= 1): linear from `begin` to `end` (-1..1), with the whole
/// `envelope` if `has_end`, otherwise only its attack. Times are non-decreasing; at each change of
/// sign there is a point of force 0.
std::vector<ForcePoint> force_profile(double begin, double end, std::int64_t length_ms,
                                      const ff_envelope& envelope, bool has_end);

}  // namespace hedgehog::gamepad
