// SPDX-License-Identifier: MIT
#include "model/thermal/fan.h"

#include <algorithm>

namespace hedgehog::model {

bool Fan::runs(bool running, double hottest_c, double mean_a) noexcept {
  const bool busy = mean_a > kOnAboveA;
  // The negated comparison turns the fan on for NaN.
  if (busy || !(hottest_c <= kOnAboveC)) return true;
  return running && hottest_c >= kOffBelowC;
}

std::uint8_t Fan::step(double hottest_c, double current_a, double dt_s) noexcept {
  mean_a_ += (current_a - mean_a_) * std::min(1.0, dt_s / kMeanS);
  on_ = runs(on_, hottest_c, mean_a_);
  return on_ ? kFullDuty : 0;
}

}  // namespace hedgehog::model
