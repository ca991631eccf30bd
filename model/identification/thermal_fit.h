// SPDX-License-Identifier: MIT
// The thermal network of a ball by least squares from how it was heated and how it cooled. Pure.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/coils.h"
#include "model/identification/heat_record.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// Capacities and resistances are those of the ball as this board measures voltage and current: the
/// gains of both are in them, as they are in what the daemon works out from them.
struct ThermalFound {
  ThermalModel thermal;
  /// Standard deviations as shares, from the fit's covariance and its residuals, in the place of
  /// each value (`sensor_winding` apart).
  struct Shares {
    std::array<double, kCoils> winding_j_k{};
    double core_j_k = 0.0;
    std::array<double, kCoils> winding_to_core_k_w{};
    double core_to_room_fan_k_w = 0.0;
    double core_to_room_still_k_w = 0.0;
    double sensor_lag_s = 0.0;
  } deviation;
  /// Within so large a share each constant lies that matters while a winding is hot: 2.5 standard
  /// deviations and what the model itself may be off, no less than a device file takes. That of
  /// the standing fan is not among them: the fan turns whenever the ball is warm.
  double uncertainty = 0.2;
  double still_uncertainty = 0.2;
  /// R25 against those that the fit was given, and the room, C.
  std::array<double, kCoils> resistance_gain{1.0, 1.0, 1.0};
  double ambient_c = 25.0;
  /// The thermometer would fit any other winding much worse.
  bool sensor_certain = false;
  /// Weighted residuals, root of the mean square: about 1 when the ball is what the model says.
  double misfit = 0.0;
};

/// `expected`: where the fit starts; 40 % off is still found. nullopt: the samples do not determine
/// a network (too few, too little heat: 20 % would be left), or the ball is not one of four nodes
/// (misfit above 5).
std::optional<ThermalFound> fit_thermal(const std::vector<HeatRun>& runs,
                                        const std::array<double, kCoils>& r25_ohm,
                                        const ThermalModel& expected);

}  // namespace hedgehog::model
