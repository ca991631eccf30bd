// SPDX-License-Identifier: MIT
// A force over time as straight lines: what base force, ramp and envelope come to. Pure.
#pragma once

#include <linux/input.h>

#include <cstdint>
#include <vector>

namespace hedgehog::gamepad {

/// The number that Linux writes a whole force with.
inline constexpr double kFullForce = 0x7fff;

struct ForcePoint {
  std::int64_t t_ms = 0;
  double force = 0.0;  // -1..1; negative: towards the opposite side
  friend bool operator==(const ForcePoint&, const ForcePoint&) = default;
};

/// The force from 0 to `length_ms` (>= 1): evenly from `begin` to `end` (-1..1), with `envelope`
/// over it if `has_end`, and else only its attack. Times never fall; a point of force 0 stands
/// wherever the sign changes.
std::vector<ForcePoint> force_profile(double begin, double end, std::int64_t length_ms,
                                      const ff_envelope& envelope, bool has_end);

}  // namespace hedgehog::gamepad
