// SPDX-License-Identifier: MIT
// Strength of a blow: few steps that people can distinguish, and a limited rate of pulses.
//
// People notice a change of force of 13 % (just noticeable difference: thesis, experiment 2). Eight
// steps from the perception threshold, 2.1 A, to full strength, 15 A, in equal ratios, are 32 %
// apart: step k is 2.1 A * (full / 2.1 A)^(k/7). Reduced to 40 %, full = 6 A, they are still 16 %
// apart.
#pragma once

#include <algorithm>
#include <cmath>

namespace hedgehog::racer {

inline constexpr int kSteps = 8;
/// Impulses of the first and the last step; Newton seconds.
inline constexpr double kMinHitImpulse = 150.0;
inline constexpr double kMaxHitImpulse = 8000.0;

/// 0..kSteps - 1; logarithmic, because a wall is many times harder than a crate.
inline int step_of(double impulse_n_s) noexcept {
  const double share = std::log(std::max(impulse_n_s, kMinHitImpulse) / kMinHitImpulse) /
                       std::log(kMaxHitImpulse / kMinHitImpulse);
  return static_cast<int>(std::lround((kSteps - 1) * std::min(share, 1.0)));
}

/// The strength of a step in ampere. `felt_a`: `hello.limits.felt_a`; `full_a`: the last step. A
/// ball limited to the perception threshold has one strength only.
inline double strength_of(int step, double felt_a, double full_a) noexcept {
  const double last_a = std::max(felt_a, full_a);
  return felt_a * std::pow(last_a / felt_a, static_cast<double>(step) / (kSteps - 1));
}

/// Relative to full strength: a skid lasts, so it is weaker than the strongest blow. `amount`: 0 to
/// 1.
inline constexpr double kMaxSkid = 0.5;
inline double skid_strength(double amount, double felt_a, double full_a) noexcept {
  return felt_a + amount * (std::max(felt_a, kMaxSkid * full_a) - felt_a);
}

/// Rate limit of pulses: one in 0.25 s, except for a harder one, which passes at once.
class PulseGate {
 public:
  static constexpr double kApartS = 0.25;

  bool passes(int step, double time_s) noexcept {
    const bool soon = step_ >= 0 && time_s >= at_s_ && time_s - at_s_ < kApartS;
    if (soon && step <= step_) return false;
    step_ = step;
    at_s_ = time_s;
    return true;
  }

 private:
  int step_ = -1;
  double at_s_ = 0.0;
};

}  // namespace hedgehog::racer
