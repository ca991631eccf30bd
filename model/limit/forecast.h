// SPDX-License-Identifier: MIT
// How long a current can flow, by the nominal model of the ball. What `thermal.forecast`,
// `headroom_s`, `burst_s` and every admission say.
#pragma once

#include <optional>

#include "model/limit/forecast_start.h"
#include "model/limit/limits.h"
#include "model/thermal/thermal_flow.h"

namespace hedgehog::model {

/// What is asked: the rms current of each winding, and the highest norm that occurs in the pattern.
struct AskedCurrents {
  Vec3 rms_a;
  double peak_a = 0.0;

  /// A constant current.
  static AskedCurrents constant(const Vec3& a) noexcept { return {a, norm(a)}; }
};

/// Seconds from now; none = never (within 4 h).
struct Forecast {
  /// Until the law, or the skin, first allows less than the asked peak.
  std::optional<double> seconds_to_derating;
  /// Until a winding would be at `Limits::trip_c` (70 C), if nothing were reduced.
  std::optional<double> seconds_to_limit;
  /// Scaled to this peak (for a constant current: this norm) it can flow for ever unreduced, A;
  /// at most `Limits::current_a`.
  double sustainable_a = 0.0;
  /// Coils off from now on: until the full `Limits::current_a` is allowed again.
  std::optional<double> recovery_s;
};

/// The temperature above which less than `peak_a` is allowed: the inverse of `allowed_current`. A
/// peak above `limits.current_a` counts as that.
Celsius derating_temperature(const Limits& limits, Amps peak) noexcept;

/// One ball with its limits. Immutable; any thread, allocates nothing, at most 0.5 ms a question.
class Forecaster {
 public:
  Forecaster(const CoilModel& coils, const ThermalModel& thermal, const Limits& limits) noexcept
      : coils_(coils), thermal_(thermal), limits_(limits) {}

  /// All answers about `asked`. When nothing is asked (zero): about `asked.peak_a` = 0 nothing is
  /// ever reduced, and `sustainable_a` is that of the worst coil.
  Forecast forecast(const ForecastStart& start, const AskedCurrents& asked) const noexcept;
  /// `current_a` without a direction: each answer for the coil where it is worst.
  Forecast forecast_worst_coil(const ForecastStart& start, double current_a) const noexcept;

  /// `headroom_s`: until `asked` is first derated.
  std::optional<double> seconds_to_derating(const ForecastStart& start,
                                            const AskedCurrents& asked) const noexcept;
  /// `burst_s`: how long the full `Limits::current_a` could flow from now (worst coil). None only
  /// for limits that low that it never ends.
  std::optional<double> burst_s(const ForecastStart& start) const noexcept;
  std::optional<double> recovery_s(const ForecastStart& start) const noexcept;
  double sustainable_a(const ForecastStart& start, const AskedCurrents& asked) const noexcept;

 private:
  /// All but the recovery, which depends on `start` alone.
  Forecast under_load(const ForecastStart& start, const AskedCurrents& asked) const noexcept;

  CoilModel coils_;
  ThermalModel thermal_;
  Limits limits_;
};

}  // namespace hedgehog::model
