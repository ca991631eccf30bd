// SPDX-License-Identifier: MIT
// Thermal limiter: maximum current as a function of temperature. Figures: daemon/safety.md.
#pragma once

#include <limits>

#include "model/estimate/thermal_observer.h"
#include "model/limit/limited_currents.h"
#include "model/limit/limits.h"

namespace hedgehog::model {

/// Current allowed at `hottest`: 15 A up to 60 C; I^2 falls linearly to 25 at 67 C, then the
/// current to zero at 69 C (values from `limits`). NaN or infinite: zero.
Amps allowed_current(const Limits& limits, Celsius hottest) noexcept;

/// Real-time safe; trivially copyable.
class ThermalLimiter {
 public:
  ThermalLimiter() noexcept = default;
  explicit ThermalLimiter(const Limits& limits) noexcept : limits_(limits) {}

  /// New limits; they take effect at the next `limit`.
  void set_limits(const Limits& limits) noexcept { limits_ = limits; }
  const Limits& limits() const noexcept { return limits_; }
  /// Additional ceiling by the skin temperature; takes effect as `set_limits`.
  void set_ceiling(Amps ceiling) noexcept { ceiling_ = ceiling; }
  /// Norm allowed at the last `limit`, ampere: `allowed_current` at the low-pass filtered
  /// temperature, at most the ceiling.
  Amps allowed() const noexcept { return allowed_; }
  /// True if the last `limit` replaced a non-finite request or one above 1000 A by zero.
  bool rejected() const noexcept { return rejected_; }

  /// `wanted` scaled as a whole (keeping its direction) to the current allowed at `estimate`; zero
  /// if it is not finite. Windings not yet measured after a restart are limited to
  /// `limits.continuous_a`; undriven ones do not limit the others. Call once every `dt_s`, also
  /// with zero: the temperature is low-pass filtered here against noise.
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
