// SPDX-License-Identifier: MIT
// Currents as only the limiter can create them, for a cold ball with all windings measured.
#pragma once

#include "model/limit/thermal_limiter.h"

namespace hedgehog::device {

inline model::LimitedCurrents limited(const model::Vec3& requested_a) {
  model::ThermalEstimate cold;
  cold.measured = {true, true, true};
  return model::ThermalLimiter().limit({requested_a}, cold);
}

inline constexpr std::array<double, model::kCoils> kColdOhm{0.45, 0.45, 0.45};

}  // namespace hedgehog::device
