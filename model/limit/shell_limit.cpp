// SPDX-License-Identifier: MIT
#include "model/limit/shell_limit.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::model {

Amps shell_allowed_current(const Limits& limits, double shell_c) noexcept {
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

Celsius shell_derating_temperature(Amps peak) noexcept {
  constexpr double kSustained = kShellSustainedA * kShellSustainedA;
  constexpr double kMore = kShellFullA * kShellFullA - kSustained;
  const double a = std::clamp(peak.value, 0.0, kShellFullA);
  if (a <= kShellSustainedA)
    return Celsius(kShellZeroC - (kShellZeroC - kShellSustainC) * a / kShellSustainedA);
  return Celsius(kShellSustainC - (kShellSustainC - kShellReduceC) * (a * a - kSustained) / kMore);
}

}  // namespace hedgehog::model
