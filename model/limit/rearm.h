// SPDX-License-Identifier: MIT
// How cool the ball must be before it may be armed again after a trip by heat.
#pragma once

#include <algorithm>

#include "model/limit/limits.h"

namespace hedgehog::model {

/// Below max(limits.rearm_c, room + 10 K), degrees Celsius: in a hot room the ball never gets as
/// cool as `rearm_c`. The controller's rule, and what people are told
/// of it.
inline double rearm_below_c(const Limits& limits, double ambient_c) noexcept {
  constexpr double kAboveAmbientK = 10.0;
  return std::max(limits.rearm_c, ambient_c + kAboveAmbientK);
}

}  // namespace hedgehog::model
