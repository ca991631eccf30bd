// SPDX-License-Identifier: MIT
// Winding currents that the thermal limiter has passed. Only `ThermalLimiter` can make one that is
// not zero, and the board driver accepts nothing else, so that no code path can drive a coil around
// the limiter.
#pragma once

#include "model/coils.h"

namespace hedgehog::model {

class LimitedCurrents {
 public:
  constexpr LimitedCurrents() noexcept = default;  // zero: always allowed

  constexpr const Vec3& a() const noexcept { return a_; }

 private:
  friend class ThermalLimiter;
  constexpr explicit LimitedCurrents(const Vec3& a) noexcept : a_(a) {}

  Vec3 a_;
};

}  // namespace hedgehog::model
