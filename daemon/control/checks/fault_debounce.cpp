// SPDX-License-Identifier: MIT
#include "daemon/control/checks/fault_debounce.h"

#include <algorithm>

namespace hedgehog::control {

bool FaultDebounce::step(bool wrong, double dt_s, double hold_s) noexcept {
  const double counted_s = std::min(dt_s, hold_s / 3.0);
  held_s_ = wrong ? std::min(held_s_ + counted_s, hold_s) : std::max(0.0, held_s_ - counted_s);
  return held_s_ > 0.0 && held_s_ >= hold_s - 0.5 * counted_s;
}

}  // namespace hedgehog::control
