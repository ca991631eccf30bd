// SPDX-License-Identifier: MIT
#include "model/estimate/winding_thermometer.h"

#include <cmath>

namespace hedgehog::model {
namespace {

// Maximum warming of the winding while the reference is taken; a 20 % error of the capacity causes
// a fifth of it.
constexpr double kMaxWarmedK = 3.0;
// Data required for a reference: 0.16 s of 15 A, 1.4 s of 5 A; the minimum applies when it gets too
// warm.
constexpr double kEnoughA2S = 36.0;
constexpr double kMinA2S = 20.0;
// Winding and core equalise with R12 C; 1.5 times as long for a slow ball.
constexpr double kSlowest = 1.5;

}  // namespace

WindingThermometer::WindingThermometer(const CoilModel& coils, const ThermalModel& thermal,
                                       int coil) noexcept
    : joule_per_k_(thermal.winding_j_k[static_cast<std::size_t>(coil)]),
      rest_s_(kSlowest * thermal.winding_to_core_k_w[static_cast<std::size_t>(coil)] *
              joule_per_k_),
      meter_(coils.inductance_h),
      r25_ohm_(coils.r25_ohm[static_cast<std::size_t>(coil)]) {}

void WindingThermometer::step(const WindingReading& reading, double dt_s) noexcept {
  reference_taken_ = false;
  meter_.step(reading.voltage_v, reading.before_a, reading.after_a, reading.measured, dt_s);
  if (rested() && reading.reference.valid && (weight_a2s_ == 0.0 || !meter_.valid())) {
    rest_c_ = reading.reference.celsius;
    warmed_k_ = above_k_;
    comparing_ = true;
    weight_a2s_ = weighted_ohm_ = weighted_per_ampere_ = 0.0;
  }
  const double warming_k = reading.loss_w * dt_s / joule_per_k_;
  above_k_ += warming_k - above_k_ * dt_s / rest_s_;
  warmed_k_ += warming_k;
  if (comparing_) compare(reading, dt_s);
}

void WindingThermometer::compare(const WindingReading& reading, double dt_s) noexcept {
  if (meter_.valid() && reading.measured) {
    const double mean_a = 0.5 * (reading.before_a + reading.after_a);
    const double weight = mean_a * mean_a * dt_s;
    const double now_c = rest_c_ + warmed_k_;
    const double r25 = meter_.resistance_ohm() / resistance_at(Ohms(1.0), Celsius(now_c)).value;
    weight_a2s_ += weight;
    weighted_ohm_ += weight * r25;
    weighted_per_ampere_ += weight * meter_.per_ampere();
  }
  const bool late = warmed_k_ > kMaxWarmedK;
  if (weight_a2s_ >= (late ? kMinA2S : kEnoughA2S)) {
    r25_ohm_ = weighted_ohm_ / weight_a2s_;
    reference_per_ampere_ = weighted_per_ampere_ / weight_a2s_;
    referenced_ = true;
    reference_taken_ = true;
    comparing_ = false;
  }
  if (late) comparing_ = false;
}

double WindingThermometer::celsius() const noexcept {
  const double ohm = meter_.resistance_ohm();
  return ohm > 0.0 ? temperature_at(Ohms(r25_ohm_), Ohms(ohm)).value : 25.0;
}

double WindingThermometer::noise_k() const noexcept {
  constexpr double kDeviations = 3.0;
  return kDeviations * meter_.noise() * kelvins_per_share(Celsius(celsius()));
}

double WindingThermometer::bias_k() const noexcept {
  const double apart = std::abs(meter_.per_ampere() - reference_per_ampere_);
  return meter_.offset_a() * apart * kelvins_per_share(Celsius(celsius()));
}

}  // namespace hedgehog::model
