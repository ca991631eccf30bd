// SPDX-License-Identifier: MIT
#include "model/estimate/thermal_winding_meter.h"

#include <algorithm>
#include <cmath>

#include "model/tick.h"

namespace hedgehog::model {
namespace {

// Weight of the nominal inductance, (A/s)^2 s. Far above the effect of quantised currents (10 mA a
// tick: 5), far below that of a real step (4 A a tick: 16 000).
constexpr double kInductanceFirmness = 100.0;
constexpr double kNoiseFirmness = 10.0;
// Minimum data for a winding to count as measured.
constexpr double kMinDrivenS = 0.004;
constexpr double kMinChargeA2S =
    0.6 * WindingMeter::kMemoryS * WindingMeter::kMinCurrentA * WindingMeter::kMinCurrentA;

// While a current changes, an unsigned sensor misses what flows against its bridge. Error of V/I
// per agitation, measured with random effects.
constexpr double kMissedPerAgitation = 0.1;

}  // namespace

void WindingMeter::step(double voltage_v, double before_a, double after_a, bool measured,
                        double dt_s) noexcept {
  const double keep = std::max(0.0, 1.0 - dt_s / kMemoryS);
  ii_ *= keep;
  offset_ *= keep;
  id_ *= keep;
  dd_ *= keep;
  vi_ *= keep;
  vd_ *= keep;
  driven_s_ *= keep;
  measured_s_ *= keep;
  weights_ *= keep * keep;
  if (measured) {
    const double mean_a = 0.5 * (before_a + after_a);
    const double slope_a_s = (after_a - before_a) / kTickSeconds;
    ii_ += mean_a * mean_a * dt_s;
    offset_ += (accuracy_.signs ? mean_a : std::abs(mean_a)) * dt_s;
    measured_s_ += dt_s;
    weights_ += mean_a * mean_a * dt_s * dt_s;
    id_ += mean_a * slope_a_s * dt_s;
    dd_ += slope_a_s * slope_a_s * dt_s;
    vi_ += voltage_v * mean_a * dt_s;
    vd_ += voltage_v * slope_a_s * dt_s;
    if (std::abs(mean_a) >= kMinCurrentA) driven_s_ += dt_s;
  }
  valid_ = driven_s_ >= kMinDrivenS && ii_ >= kMinChargeA2S;
  if (!valid_) return;
  // Subtracts the noise of the currents, which appears as changes without a voltage. It is known to
  // a few tenths only; the weight of the nominal inductance covers the rest.
  const double noise_a_s = accuracy_.noise_a / kTickSeconds;
  const double noise = 2.0 * noise_a_s * noise_a_s;
  const double firmness = kInductanceFirmness + kNoiseFirmness * noise * kMemoryS;
  const double dd = std::max(dd_ - noise * measured_s_, id_ * id_ / ii_) + firmness;
  const double vd = vd_ + firmness * nominal_h_;
  const double determinant = ii_ * dd - id_ * id_;  // > 0: ii dd >= id^2 + ii firmness
  resistance_ohm_ = (vi_ * dd - vd * id_) / determinant;
}

double WindingMeter::noise() const noexcept {
  const double missed = accuracy_.signs ? 0.0 : kMissedPerAgitation * agitation();
  return std::hypot(accuracy_.noise_a * std::sqrt(weights_) / ii_, missed);
}

double WindingMeter::agitation() const noexcept {
  const double noise_a_s = accuracy_.noise_a / kTickSeconds;
  const double changes = std::max(0.0, dd_ - 2.0 * noise_a_s * noise_a_s * measured_s_);
  return std::sqrt(changes / ii_) * nominal_h_ / resistance_ohm_;
}

double WindingMeter::current_a() const noexcept {
  return measured_s_ > 0.0 ? std::sqrt(ii_ / measured_s_) : 0.0;
}

}  // namespace hedgehog::model
