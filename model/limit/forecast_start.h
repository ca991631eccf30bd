// SPDX-License-Identifier: MIT
// From what a forecast starts.
#pragma once

#include <limits>

#include "model/estimate/skin_estimate.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// From what a forecast starts: the observer's estimate and the fan. Trivially copyable.
struct ForecastStart {
  ThermalState nodes;
  double ambient_c = 25.0;
  /// The fan as it is, and whether it can run at all (false: dead, foretold without it).
  bool fan_running = false;
  bool fan_works = true;
  /// By how much the limiter's bound is above the hottest node, K: what the instruments leave open.
  double above_k = 0.0;
  /// The skin as it is followed, and by how much what limits is above it, K; -infinity: no skin
  /// limits.
  SkinEstimate skin;
  double skin_above_k = -std::numeric_limits<double>::infinity();
  /// The 30 s mean of |I| now, A; above 3 A it keeps the fan running.
  double mean_current_a = 0.0;
};

}  // namespace hedgehog::model
