// SPDX-License-Identifier: MIT
#include "daemon/control/fan.h"

#include <algorithm>

namespace hedgehog::control {

std::uint8_t Fan::step(double hottest_c, double current_a, double dt_s) noexcept {
  mean_a_ += (current_a - mean_a_) * std::min(1.0, dt_s / kMeanS);
  const bool busy = mean_a_ > kOnAboveA;
  // Written so that a temperature that is not a number turns it on.
  if (busy || !(hottest_c <= kOnAboveC))
    on_ = true;
  else if (hottest_c < kOffBelowC)
    on_ = false;
  return on_ ? 255 : 0;
}

}  // namespace hedgehog::control
