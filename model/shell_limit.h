// SPDX-License-Identifier: MIT
// How much current may flow when the skin of the ball is warm. 43 C is what may be held for hours
// (ECMA-287; IEC 60601-1 for parts held 10 minutes and more), 48 C what may be touched for minutes.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/limits.h"
#include "model/units.h"

namespace hedgehog::model {

inline constexpr double kShellReduceC = 43.0;
inline constexpr double kShellZeroC = 46.0;
inline constexpr double kShellTripC = 48.0;

/// The norm allowed at the skin temperature `shell_c`: everything up to 43 C, then I^2 falls
/// linearly to zero at 46 C: the skin lags behind the heat that is already in the core, so the last
/// two kelvins are for that. Not a number: zero.
inline Amps shell_allowed_current(const Limits& limits, double shell_c) noexcept {
  if (!(shell_c < kShellZeroC)) return Amps(0.0);
  const double share = (kShellZeroC - shell_c) / (kShellZeroC - kShellReduceC);
  return Amps(std::max(0.0, limits.current_a) * std::sqrt(std::min(1.0, share)));
}

}  // namespace hedgehog::model
