// SPDX-License-Identifier: MIT
// Thermal limiter: maximum current as a function of temperature. Figures: daemon/safety.md.
#pragma once

#include <limits>

#include "model/estimate/thermal_observer.h"
#include "model/limit/limited_currents.h"
#include "model/limit/limits.h"

namespace hedgehog::model {

/// Current allowed at `hottest` by the law of `Limits`. NaN or infinite: zero.
Amps allowed_current(const Limits& limits, Celsius hottest) noexcept;

/// Real-time safe; trivially copyable.
class ThermalLimiter {
 public:
  ThermalLimiter() noexcept = default;
  explicit ThermalLimiter(const Limits& limits) noexcept : limits_(limits) {}

  /// Takes effect at the next `limit`, as does the additional ceiling by the skin temperature.
  void set_limits(const Limits& limits) noexcept { limits_ = limits; }
  const Limits& limits() const noexcept { return limits_; }
  void set_ceiling(Amps ceiling) noexcept { ceiling_ = ceiling; }
  /// Norm at the last `limit`: `allowed_current` at the filtered temperature, at most the ceiling.
  Amps allowed() const noexcept { return allowed_; }
  /// The last `limit` replaced a non-finite request or one above 1000 A by zero.
  bool rejected() const noexcept { return rejected_; }

  /// `wanted` scaled as a whole to the current allowed at `estimate`; zero if it is not finite.
  /// Driven windings not yet measured after a restart limit it to `limits.continuous_a`. Call once
  /// every `dt_s`, also with zero: the temperature is low-pass filtered here against noise.
  LimitedCurrents limit(const CoilCurrents& wanted, const ThermalEstimate& estimate,
                        double dt_s = kTickSeconds) noexcept;

 private:
  Limits limits_;
  Amps ceiling_{std::numeric_limits<double>::infinity()};
  Amps allowed_{0.0};
  double filtered_c_ = 0.0;
  bool started_ = false;
  bool rejected_ = false;
};

}  // namespace hedgehog::model
