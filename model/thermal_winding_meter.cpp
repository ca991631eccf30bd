// SPDX-License-Identifier: MIT
#include "model/thermal_winding_meter.h"

#include <algorithm>
#include <cmath>

#include "model/tick.h"

namespace hedgehog::model {
namespace {

// How firmly the nominal inductance is believed, (A/s)^2 s. Far above what quantised currents
// pretend (10 mA a tick: 5), far below what a real step shows (4 A a tick: 16 000).
constexpr double kInductanceFirmness = 100.0;
// Before this much was seen, a winding counts as not measured.
constexpr double kLeastDrivenS = 0.004;
constexpr double kLeastChargeA2S =
    0.6 * WindingMeter::kMemoryS * WindingMeter::kLeastCurrentA * WindingMeter::kLeastCurrentA;

}  // namespace

void WindingMeter::step(double voltage_v, double before_a, double after_a, bool measured,
                        double dt_s) noexcept {
  const double keep = std::max(0.0, 1.0 - dt_s / kMemoryS);
  ii_ *= keep;
  id_ *= keep;
  dd_ *= keep;
  vi_ *= keep;
  vd_ *= keep;
  driven_s_ *= keep;
  if (measured) {
    const double mean_a = 0.5 * (before_a + after_a);
    const double slope_a_s = (after_a - before_a) / kTickSeconds;
    ii_ += mean_a * mean_a * dt_s;
    id_ += mean_a * slope_a_s * dt_s;
    dd_ += slope_a_s * slope_a_s * dt_s;
    vi_ += voltage_v * mean_a * dt_s;
    vd_ += voltage_v * slope_a_s * dt_s;
    if (std::abs(mean_a) >= kLeastCurrentA) driven_s_ += dt_s;
  }
  valid_ = driven_s_ >= kLeastDrivenS && ii_ >= kLeastChargeA2S;
  if (!valid_) return;
  const double dd = dd_ + kInductanceFirmness;
  const double vd = vd_ + kInductanceFirmness * nominal_h_;
  const double determinant = ii_ * dd - id_ * id_;  // > 0: ii dd_ >= id^2, and ii firmness > 0
  resistance_ohm_ = (vi_ * dd - vd * id_) / determinant;
}

}  // namespace hedgehog::model
