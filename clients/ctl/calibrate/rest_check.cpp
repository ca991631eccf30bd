// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/rest_check.h"

#include <algorithm>
#include <cmath>

#include "clients/ctl/terminal/words.h"
#include "model/coils.h"
#include "model/thermal/fan.h"
#include "model/thermal/thermal_flow.h"

namespace hedgehog::client {
namespace {

/// Two intact thermistors at one temperature may differ by their tolerance of 1 K each, with
/// margin.
constexpr double kMaxThermistorsApartK = 4.0;
/// Convergence time of the daemon's estimate after a start without prior state, s.
constexpr double kUnsureS = 180.0;
/// Time constant of the equalization of winding and core in a slow ball, s: R12 C, both 20 % above
/// typical.
constexpr double kSlowRestS = 85.0;
/// Two thirds of the decay of 2 K in a slow ball within `kMinIntervalS`; plus the noise of two
/// measurements, as a number of standard deviations.
constexpr double kMaxDriftK = 0.5;
constexpr double kNoiseDeviations = 2.5;
constexpr double kCoolAmbientC = 20.0;
/// Safety factor for a ball slower than by its own constants.
constexpr double kSlower = 1.3;
constexpr double kLongestWaitS = 7200.0;

struct Apart {
  double k = 0.0;  // signed, above the thermometer
  std::string node;
};

Apart farthest(const protocol::TemperatureStatus& t) {
  Apart most;
  const auto look = [&](double node_c, std::string name) {
    const double apart_k = node_c - reference_c(t);
    if (std::abs(apart_k) > std::abs(most.k)) most = {apart_k, std::move(name)};
  };
  for (std::size_t i = 0; i < t.coils.size(); ++i)
    look(t.coils[i], std::string("winding ") + "xyz"[i]);
  if (t.core) look(*t.core, "the core");
  return most;
}

double spread_k(const model::ThermalState& nodes) {
  const auto [lowest, most] =
      std::minmax({nodes.winding_c[0], nodes.winding_c[1], nodes.winding_c[2], nodes.core_c});
  return most - lowest;
}

double rest_after_s(const protocol::TemperatureStatus& t, const model::ThermalModel& thermal) {
  model::ThermalState nodes{t.coils, t.core.value_or(reference_c(t))};
  model::HeatLoad load;
  load.ambient_c = std::min(
      {kCoolAmbientC, nodes.core_c, nodes.winding_c[0], nodes.winding_c[1], nodes.winding_c[2]});
  load.fan_running = model::hottest_winding(nodes) > model::Fan::kOffBelowC;
  constexpr double kStepS = 0.5;
  double after_s = 0.0;
  while (spread_k(nodes) > kMaxApartK / 2.0 && after_s < kLongestWaitS) {
    load.fan_running = model::Fan::runs(load.fan_running, model::hottest_winding(nodes), 0.0);
    nodes = model::advanced(nodes, model::heating_rates(thermal, nodes, load), kStepS);
    after_s += kStepS;
  }
  return kSlower * after_s;
}

}  // namespace

double reference_c(const protocol::TemperatureStatus& t) {
  if (!t.sensors) return t.sensor.value_or(25.0);
  return ((*t.sensors)[0] + (*t.sensors)[1] + (*t.sensors)[2]) / 3.0;
}

std::string minutes_text(double seconds) {
  const int minutes = std::max(1, static_cast<int>(std::ceil(seconds / 60.0)));
  return std::to_string(minutes) + (minutes == 1 ? " minute" : " minutes");
}

RestDeviation rest_deviation(const protocol::TemperatureStatus& t,
                             const model::ThermalModel& thermal) {
  if (!t.model || !t.upper)
    return {"the temperatures of the windings are not known yet", 20.0, kUnsureS};
  const Apart most = farthest(t);
  if (std::abs(most.k) > kMaxApartK) {
    return {most.node + " is " + fixed(std::abs(most.k), 1) + " K " +
                (most.k > 0.0 ? "warmer" : "cooler") + " than the thermometer",
            std::abs(most.k), rest_after_s(t, thermal)};
  }
  if (t.sensors) {
    const auto [lowest, highest] = std::minmax_element(t.sensors->begin(), t.sensors->end());
    if (*highest - *lowest > kMaxThermistorsApartK) {
      return {"the thermometers of the windings are " + fixed(*highest - *lowest, 1) + " K apart",
              *highest - *lowest, kSlowRestS * std::log(*highest - *lowest)};
    }
  }
  const double uncertainty_k = *t.upper - *t.model;
  if (uncertainty_k > kMaxUncertaintyK) {
    return {"the thermal estimate has not converged: a winding may be " + fixed(uncertainty_k, 0) +
                " K warmer than estimated",
            uncertainty_k, kUnsureS};
  }
  return {{}, std::abs(most.k), 0.0};
}

RestDeviation drift_of(const WindingMeasurement& first, const WindingMeasurement& second) {
  const double left = std::exp(-(second.t_s - first.t_s) / kSlowRestS);
  RestDeviation worst;
  for (std::size_t i = 0; i < first.resistance_ohm.size(); ++i) {
    const double share = second.resistance_ohm[i] / first.resistance_ohm[i] - 1.0;
    const double warmed_k = share * model::kelvins_per_share(model::Celsius(first.reference_c));
    const double drift_k = warmed_k - (second.reference_c - first.reference_c);
    const double apart_k = std::abs(drift_k) / (1.0 - left);
    if (apart_k <= worst.apart_k) continue;
    worst.apart_k = apart_k;
    const double noise_k = std::hypot(first.error[i], second.error[i]) *
                           model::kelvins_per_share(model::Celsius(first.reference_c));
    if (std::abs(drift_k) <= kMaxDriftK + kNoiseDeviations * noise_k) continue;
    worst.what = std::string("by its resistance winding ") + "xyz"[i] + " has " +
                 (drift_k < 0.0 ? "cooled" : "warmed") + " by " + fixed(std::abs(drift_k), 1) +
                 " K against the thermometer within " + fixed(second.t_s - first.t_s, 0) + " s";
    worst.wait_s = kSlower * kSlowRestS * std::max(1.0, std::log(2.0 * apart_k / kMaxApartK));
  }
  return worst;
}

}  // namespace hedgehog::client
