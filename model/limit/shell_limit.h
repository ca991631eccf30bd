// SPDX-License-Identifier: MIT
// Current limit by the skin temperature of the ball. 43 C may be held for hours (ECMA-287; IEC
// 60601-1 for parts held 10 minutes and more), 48 C touched for minutes.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/limit/limits.h"
#include "model/units.h"

namespace hedgehog::model {

inline constexpr double kShellReduceC = 38.0;
inline constexpr double kShellSustainC = 42.8;
inline constexpr double kShellZeroC = 43.0;
inline constexpr double kShellTripC = 48.0;
/// Allowed currents just above kShellReduceC and at kShellSustainC; the limits may allow less.
inline constexpr double kShellFullA = 15.0;
inline constexpr double kShellSustainedA = 5.0;

/// Norm allowed at the skin temperature `shell_c`: no limit up to 38 C, then I^2 falls linearly
/// from 15^2 to 5^2 at 42.8 C, then the current to zero at 43 C. Derating begins early enough that
/// the heat of a burst, which reaches the skin within a minute, still allows 5 A. NaN: zero.
inline Amps shell_allowed_current(const Limits& limits, double shell_c) noexcept {
  if (!(shell_c < kShellZeroC)) return Amps(0.0);
  if (shell_c <= kShellReduceC) return Amps(std::max(0.0, limits.current_a));
  constexpr double kSustained = kShellSustainedA * kShellSustainedA;
  constexpr double kMore = kShellFullA * kShellFullA - kSustained;
  const double share = (kShellSustainC - shell_c) / (kShellSustainC - kShellReduceC);
  const double last = (kShellZeroC - shell_c) / (kShellZeroC - kShellSustainC);
  const double allowed =
      share >= 0.0 ? std::sqrt(kSustained + kMore * std::min(1.0, share)) : kShellSustainedA * last;
  return Amps(std::clamp(allowed, 0.0, std::max(0.0, limits.current_a)));
}

/// Skin temperature above which less than `peak` is allowed: the inverse. A peak above 15 A counts
/// as 15 A.
inline Celsius shell_derating_temperature(Amps peak) noexcept {
  constexpr double kSustained = kShellSustainedA * kShellSustainedA;
  constexpr double kMore = kShellFullA * kShellFullA - kSustained;
  const double a = std::clamp(peak.value, 0.0, kShellFullA);
  if (a <= kShellSustainedA)
    return Celsius(kShellZeroC - (kShellZeroC - kShellSustainC) * a / kShellSustainedA);
  return Celsius(kShellSustainC - (kShellSustainC - kShellReduceC) * (a * a - kSustained) / kMore);
}

}  // namespace hedgehog::model
