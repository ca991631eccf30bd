// SPDX-License-Identifier: MIT
// Whether a ball is at one temperature, so that its thermometer tells that of every winding. Pure
// functions.
#pragma once

#include <array>
#include <string>

#include "model/thermal/thermal_model.h"
#include "protocol/values/description.h"
#include "protocol/values/status.h"

namespace hedgehog::client {

/// Windings, core and thermometer of a ball at rest differ by no more, K.
inline constexpr double kMaxApartK = 2.0;
/// The estimate of the hottest winding may be this much too low, K; beyond it says nothing of rest.
/// Half as much again as with one thermistor and nothing else to know by.
inline constexpr double kMaxUnsureK = 3.0;
/// The second look at the windings comes at least this long after the first, s.
inline constexpr double kLooksApartS = 40.0;

/// Why the ball does not count as at rest.
struct Unrest {
  /// What is off, as a sentence without full stop; empty: it is at rest.
  std::string what;
  /// By how much the thermometer may differ from a winding, K.
  double apart_k = 0.0;
  /// How long to wait, s.
  double wait_s = 0.0;

  bool any() const noexcept { return !what.empty(); }
};

/// The temperature at which resistances are measured, C: the mean of the thermistors where each
/// winding has one, else the only one. REQUIRES: t.sensor.
double reference_c(const protocol::TemperatureStatus& t);

/// The constants of the thermal network that a daemon describes; the others stay typical.
model::ThermalModel thermal_model_of(const protocol::ThermalDescription& described);

/// By the daemon's estimate and the thermistors; how long to wait by the constants `thermal`, in a
/// room of 20 C or as cool as the ball. REQUIRES: t.sensor.
Unrest unrest_of(const protocol::TemperatureStatus& t, const protocol::ThermalDescription& thermal);

/// The windings at one moment.
struct WindingLook {
  double t_s = 0.0;
  double reference_c = 25.0;
  std::array<double, 3> resistance_ohm{};
  /// Standard deviations of those, shares.
  std::array<double, 3> error{};
};
/// By the windings themselves: one that was warmer than the thermometer at the first look comes
/// nearer to it until the second, and its resistance with it. Needs neither the daemon's estimate
/// nor R25, and gains cancel. Blind to a ball whose windings all differ alike from the thermometer.
Unrest drift_of(const WindingLook& first, const WindingLook& second);

/// "5 minutes", at least one.
std::string minutes_text(double seconds);

}  // namespace hedgehog::client
