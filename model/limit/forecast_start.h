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
  bool fan_running = false;  // at present
  bool fan_works = true;     // false: forecast without it
  double above_k = 0.0;      // limiter's bound above the hottest node: the measurement uncertainty
  /// Estimate, and the limiting skin temperature above it; -infinity: no skin limit.
  SkinEstimate skin;
  double skin_above_k = -std::numeric_limits<double>::infinity();
  double mean_current_a = 0.0;  // 30 s mean of |I|; above 3 A it keeps the fan running
};

}  // namespace hedgehog::model
