// SPDX-License-Identifier: MIT
// The law that keeps the ball cool: how much current may flow at a temperature. Its figures:
// daemon/safety.md.
#pragma once

#include <limits>

#include "model/estimate/thermal_observer.h"
#include "model/limit/limited_currents.h"
#include "model/limit/limits.h"

namespace hedgehog::model {

/// The law itself: the current that may flow at `hottest`. 15 A up to 60 C; I^2 falls linearly to
/// 25 at 67 C, then to zero at 69 C (numbers from `limits`). Not a number or infinite: zero.
Amps allowed_current(const Limits& limits, Celsius hottest) noexcept;

/// Real-time safe; trivially copyable.
class ThermalLimiter {
 public:
  ThermalLimiter() noexcept = default;
  explicit ThermalLimiter(const Limits& limits) noexcept : limits_(limits) {}

  /// New limits; they take effect at the next `limit`.
  void set_limits(const Limits& limits) noexcept { limits_ = limits; }
  const Limits& limits() const noexcept { return limits_; }
  /// Another witness of heat, the skin, allows no more than this; as `set_limits`.
  void set_ceiling(Amps ceiling) noexcept { ceiling_ = ceiling; }
  /// The norm allowed at the last `limit`, ampere: the law at the low-pass filtered temperature,
  /// under the ceiling.
  Amps allowed() const noexcept { return allowed_; }
  /// True when the last `limit` had to replace a number that was not finite or above 1000 A by
  /// zero.
  bool rejected() const noexcept { return rejected_; }

  /// `wanted` scaled as a whole (its direction stays) to what is allowed at `estimate`; zero when
  /// it is not finite. Windings not yet measured after a restart hold themselves to
  /// `limits.continuous_a`; those that are not driven hold nobody back. Call it once every `dt_s`,
  /// with zero too: the temperature is low-pass filtered here against noise.
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
