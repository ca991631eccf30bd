// SPDX-License-Identifier: MIT
// Current limit by the skin temperature of the ball. 43 C may be held for hours (ECMA-287; IEC
// 60601-1 for parts held 10 minutes and more), 48 C touched for minutes. Reasons: model/skin.md.
#pragma once

#include "model/limit/limits.h"
#include "model/units.h"

namespace hedgehog::model {

inline constexpr double kShellReduceC = 38.0;
inline constexpr double kShellSustainC = 42.8;
inline constexpr double kShellZeroC = 43.0;
inline constexpr double kShellTripC = 48.0;
inline constexpr double kShellFullA = 15.0;  // just above kShellReduceC; the limits may allow less
inline constexpr double kShellSustainedA = 5.0;  // at kShellSustainC

/// Norm allowed: no limit up to 38 C, then I^2 falls linearly from 15^2 to 5^2 at 42.8 C, then the
/// current to zero at 43 C. NaN: zero.
Amps shell_allowed_current(const Limits& limits, double shell_c) noexcept;

/// The inverse: above it less than `peak` is allowed. A peak above 15 A counts as 15 A.
Celsius shell_derating_temperature(Amps peak) noexcept;

}  // namespace hedgehog::model
