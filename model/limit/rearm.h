// SPDX-License-Identifier: MIT
// Rearm temperature after a thermal trip.
#pragma once

#include <algorithm>

#include "model/limit/limits.h"

namespace hedgehog::model {

/// max(limits.rearm_c, ambient + 10 K): in hot surroundings the ball never cools to `rearm_c`.
inline double rearm_below_c(const Limits& limits, double ambient_c) noexcept {
  constexpr double kAboveAmbientK = 10.0;
  return std::max(limits.rearm_c, ambient_c + kAboveAmbientK);
}

}  // namespace hedgehog::model
