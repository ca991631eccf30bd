// SPDX-License-Identifier: MIT
// Forecast of how long a current can flow, by the nominal model of the ball: `thermal.forecast`,
// `headroom_s`, `burst_s` and every admission.
#pragma once

#include <optional>

#include "model/limit/forecast_start.h"
#include "model/limit/limits.h"
#include "model/thermal/thermal_flow.h"

namespace hedgehog::model {

struct RequestedCurrents {
  Vec3 rms_a;           // of each winding
  double peak_a = 0.0;  // peak norm in the pattern

  static RequestedCurrents constant(const Vec3& a) noexcept { return {a, norm(a)}; }
};

/// Seconds from now; none: not within 4 h.
struct Forecast {
  /// Until the limiter, by winding or skin temperature, first allows less than the requested peak.
  std::optional<double> seconds_to_derating;
  std::optional<double> seconds_to_limit;  // until a winding reaches `trip_c` without derating
  /// Peak to which the request can be scaled to flow for ever without derating, <= `current_a`.
  double sustainable_a = 0.0;
  /// Coils off from now on: until the full `Limits::current_a` is allowed again.
  std::optional<double> recovery_s;
};

/// Inverse of `allowed_current`. A peak above `limits.current_a` counts as `limits.current_a`.
Celsius derating_temperature(const Limits& limits, Amps peak) noexcept;

/// One ball with its limits. Immutable; any thread, no allocation, at most 0.5 ms per call.
class Forecaster {
 public:
  Forecaster(const CoilModel& coils, const ThermalModel& thermal, const Limits& limits) noexcept
      : coils_(coils), thermal_(thermal), limits_(limits) {}

  /// For a peak of 0 there is no derating, and `sustainable_a` is that of the worst coil.
  Forecast forecast(const ForecastStart& start, const RequestedCurrents& requested) const noexcept;
  /// `current_a` without a direction: each value for its worst coil.
  Forecast forecast_worst_coil(const ForecastStart& start, double current_a) const noexcept;

  /// `headroom_s`: seconds until `requested` is first derated.
  std::optional<double> seconds_to_derating(const ForecastStart& start,
                                            const RequestedCurrents& requested) const noexcept;
  /// Duration of the full `Limits::current_a` (worst coil). None: limits so low that it never ends.
  std::optional<double> burst_s(const ForecastStart& start) const noexcept;
  std::optional<double> recovery_s(const ForecastStart& start) const noexcept;
  double sustainable_a(const ForecastStart& start,
                       const RequestedCurrents& requested) const noexcept;

 private:
  /// Without the recovery, which depends on `start` alone.
  Forecast under_load(const ForecastStart& start,
                      const RequestedCurrents& requested) const noexcept;

  CoilModel coils_;
  ThermalModel thermal_;
  Limits limits_;
};

}  // namespace hedgehog::model
