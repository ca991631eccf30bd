// SPDX-License-Identifier: MIT
#include "model/limit/thermal_limiter.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::model {
namespace {

// Short against the 0.5 s in which 15 A heat by one kelvin, long against a tick of sensor noise.
constexpr double kFilterS = 0.05;
constexpr double kMaxRequestA = 1000.0;

}  // namespace

Amps allowed_current(const Limits& limits, Celsius hottest) noexcept {
  const double t = hottest.value;
  if (!std::isfinite(t) || t >= limits.zero_c) return Amps(0.0);
  const double full = std::max(0.0, limits.current_a);
  const double sustained = std::clamp(limits.continuous_a, 0.0, full);
  if (t <= std::min(limits.derate_from_c, limits.sustain_c)) return Amps(full);
  if (t <= limits.sustain_c) {
    const double share = (limits.sustain_c - t) / (limits.sustain_c - limits.derate_from_c);
    return Amps(std::sqrt(sustained * sustained + (full * full - sustained * sustained) * share));
  }
  return Amps(sustained * (limits.zero_c - t) / (limits.zero_c - limits.sustain_c));
}

LimitedCurrents ThermalLimiter::limit(const CoilCurrents& wanted, const ThermalEstimate& estimate,
                                      double dt_s) noexcept {
  if (!std::isfinite(estimate.hottest_c)) {
    started_ = false;
    allowed_ = Amps(0.0);
  } else {
    if (!started_) filtered_c_ = estimate.hottest_c;
    started_ = true;
    filtered_c_ += (estimate.hottest_c - filtered_c_) * std::min(1.0, dt_s / kFilterS);
    allowed_ = allowed_current(limits_, Celsius(filtered_c_));
    if (!(allowed_.value <= ceiling_.value)) allowed_ = Amps(std::fmax(0.0, ceiling_.value));
  }

  const Vec3& a = wanted.a;
  const double length = norm(a);
  rejected_ = !is_finite(a) || !(length <= kMaxRequestA);
  if (rejected_ || length == 0.0) return LimitedCurrents();
  double scale = std::min(1.0, allowed_.value / length);
  for (int coil = 0; coil < kCoils; ++coil) {
    const double magnitude = std::abs(a[coil]);
    if (!estimate.measured[static_cast<std::size_t>(coil)] && magnitude > limits_.continuous_a)
      scale = std::min(scale, limits_.continuous_a / magnitude);
  }
  return LimitedCurrents(scale * a);
}

}  // namespace hedgehog::model
