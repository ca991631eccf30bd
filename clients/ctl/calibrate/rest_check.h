// SPDX-License-Identifier: MIT
// Checks whether a ball is at one temperature, so that its thermometer is valid for every winding.
// Pure functions.
#pragma once

#include <array>
#include <string>

#include "model/thermal/thermal_model.h"
#include "protocol/values/description.h"
#include "protocol/values/status.h"

namespace hedgehog::client {

/// Maximum difference between windings, core and thermometer of a ball at rest, K.
inline constexpr double kMaxApartK = 2.0;
/// Maximum uncertainty of the hottest winding's estimate, K; above it the estimate does not prove
/// rest. 1.5 times the uncertainty with one thermistor and no other source.
inline constexpr double kMaxUncertaintyK = 3.0;
/// Minimum time between the two measurements of the windings, s.
inline constexpr double kMinIntervalS = 40.0;

/// Why the ball is not considered at rest.
struct RestDeviation {
  /// The deviation, as a sentence without full stop; empty: at rest.
  std::string what;
  /// Possible difference between thermometer and a winding, K.
  double apart_k = 0.0;
  /// Waiting time until rest, s.
  double wait_s = 0.0;

  bool any() const noexcept { return !what.empty(); }
};

/// The temperature at which resistances are measured, C: the mean of the thermistors where each
/// winding has one, else the only one. REQUIRES: t.sensor.
double reference_c(const protocol::TemperatureStatus& t);

/// From the daemon's estimate and the thermistors; the waiting time from the constants `thermal`,
/// at an ambient temperature of 20 C or that of a cooler ball. REQUIRES: t.sensor.
RestDeviation rest_deviation(const protocol::TemperatureStatus& t,
                             const model::ThermalModel& thermal);

/// One measurement of the windings.
struct WindingMeasurement {
  double t_s = 0.0;
  double reference_c = 25.0;
  std::array<double, 3> resistance_ohm{};
  /// Relative standard deviations of those.
  std::array<double, 3> error{};
};
/// From the windings themselves: one that was warmer than the thermometer at the first measurement
/// approaches it until the second, and so does its resistance. Independent of the daemon's estimate
/// and R25; gain errors cancel. Cannot detect that all windings differ alike from the thermometer.
RestDeviation drift_of(const WindingMeasurement& first, const WindingMeasurement& second);

/// "5 minutes", at least one.
std::string minutes_text(double seconds);

}  // namespace hedgehog::client
