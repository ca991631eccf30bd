// SPDX-License-Identifier: MIT
#include "model/geometry/pin_array.h"

namespace hedgehog::model {
NearestPin nearest_pin(const PinArray& array, const Vec3& direction) noexcept {
  const Vec3 wanted = unit_or(direction, {0, 0, 1});
  NearestPin best{-1, -2.0};
  for (const Pin& pin : array.pins) {
    const double cosine = dot(pin.position, wanted);
    // Equals differ by rounding only; without the margin the answer would depend on it.
    if (cosine > best.cosine + 1e-7) best = {pin.id, cosine};
  }
  return best;
}

}  // namespace hedgehog::model
