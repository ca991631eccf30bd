// SPDX-License-Identifier: MIT
#include "model/geometry/pin_array.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/units.h"

namespace hedgehog::model {

double pin_pitch_deg(const PinArray& array) {
  // Ball of 86 pins, from a pentagon to its neighbour: physics.md section 2.
  constexpr double kThesisNearestDeg = 19.8178;
  constexpr double kMaxPitchDeg = 120.0;
  if (array.pins.size() < 2) return kThesisPitchDeg;
  std::vector<double> nearest;
  for (const Pin& pin : array.pins) {
    double cosine = -1.0;
    for (const Pin& other : array.pins)
      if (other.id != pin.id) cosine = std::max(cosine, dot(pin.position, other.position));
    nearest.push_back(std::acos(std::min(cosine, 1.0)) / kRadiansPerDegree);
  }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>((nearest.size() - 1) / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  const double pitch = kThesisPitchDeg * *middle / kThesisNearestDeg;
  return std::min(std::round(100.0 * pitch) / 100.0, kMaxPitchDeg);
}

NearestPin nearest_pin(const PinArray& array, const Vec3& direction) noexcept {
  const Vec3 wanted = unit_or(direction, {0, 0, 1});
  NearestPin best{-1, -2.0};
  for (const Pin& pin : array.pins) {
    const double cosine = dot(pin.position, wanted);
    // Ties differ by rounding only; the margin keeps the lowest id.
    if (cosine > best.cosine + 1e-7) best = {pin.id, cosine};
  }
  return best;
}

}  // namespace hedgehog::model
