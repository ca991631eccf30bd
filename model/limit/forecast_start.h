// SPDX-License-Identifier: MIT
// Initial state of a forecast.
#pragma once

#include <limits>

#include "model/estimate/skin_estimate.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// The observer's estimate and the fan. Trivially copyable.
struct ForecastStart {
  ThermalState nodes;
  double ambient_c = 25.0;
  /// Present state of the fan, and whether it works (false: forecast without it).
  bool fan_running = false;
  bool fan_works = true;
  /// Limiter's bound above the hottest node, K: the measurement uncertainty.
  double above_k = 0.0;
  /// Skin estimate, and the limiting skin temperature above it, K; -infinity: no skin limit.
  SkinEstimate skin;
  double skin_above_k = -std::numeric_limits<double>::infinity();
  /// Present 30 s mean of |I|, A; above 3 A it keeps the fan running.
  double mean_current_a = 0.0;
};

}  // namespace hedgehog::model
