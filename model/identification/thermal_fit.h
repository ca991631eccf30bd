// SPDX-License-Identifier: MIT
// Least-squares fit of the thermal network of a ball to its heating and cooling. Pure.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/coils.h"
#include "model/identification/heat_record.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// Capacities and resistances include this board's gain errors of voltage and current, as do the
/// daemon's estimates based on them.
struct ThermalFound {
  ThermalModel thermal;
  /// Relative standard deviations, from the fit's covariance and residuals.
  struct Shares {
    std::array<double, kCoils> winding_j_k{};
    double core_j_k = 0.0;
    std::array<double, kCoils> winding_to_core_k_w{};
    double core_to_ambient_fan_k_w = 0.0;
    double core_to_ambient_still_k_w = 0.0;
    double sensor_lag_s = 0.0;
  } deviation;
  /// Relative tolerance: 2.5 standard deviations plus the model error, at least the minimum of a
  /// device file; `uncertainty` is that of a warm ball, whose fan runs.
  double uncertainty = 0.2;
  double still_uncertainty = 0.2;                             // of `core_to_ambient_still_k_w`
  std::array<double, kCoils> resistance_gain{1.0, 1.0, 1.0};  // R25 relative to the given values
  double ambient_c = 25.0;
  bool sensor_certain = false;  // the thermistor fits any other winding much worse
  double misfit = 0.0;  // RMS of the weighted residuals: about 1 when the ball matches the model
};

/// `expected`: initial values; converges from 40 % off. nullopt: too few samples or too little heat
/// (tolerance above 20 %), or the four-node model does not fit (misfit above 5).
std::optional<ThermalFound> fit_thermal(const std::vector<HeatRun>& runs,
                                        const std::array<double, kCoils>& r25_ohm,
                                        const ThermalModel& expected);

}  // namespace hedgehog::model
