// SPDX-License-Identifier: MIT
#include "model/geometry/pin_array.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/geometry/goldberg.h"

namespace hedgehog::model {
namespace {

// Rings of GP(3,0) seen from the top: 0..7 carry pins, 8 and 9 are the fan's.
constexpr int kRings = 8;

/// Rounding noise off the axes, so that the top pin is (0,0,1) and not almost so.
Vec3 without_noise(Vec3 v) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(v[axis]) < 1e-9) v[axis] = 0.0;
  return unit_or(v, {0, 0, 1});
}

/// 0..2 pi anticlockwise from the front; what is at the front but for rounding is at 0.
double centre_azimuth(const Vec3& v) {
  const double azimuth = std::atan2(v.y, v.x);
  return azimuth < -1e-6 ? azimuth + 2.0 * std::numbers::pi : std::max(azimuth, 0.0);
}

PinArray make_hedgehog_86() {
  const Goldberg tkd = canonical_goldberg(3);
  PinArray array;
  array.arrangement = "tkD-86";
  for (int ring = 0; ring < kRings; ++ring) {
    std::vector<Vec3> members;
    for (const Goldberg::Face& face : tkd.faces)
      if (face.ring == ring) members.push_back(without_noise(face.direction));
    std::sort(members.begin(), members.end(),
              [](const Vec3& a, const Vec3& b) { return centre_azimuth(a) < centre_azimuth(b); });
    array.ring_start.push_back(array.pins.size());
    for (const Vec3& position : members)
      array.pins.push_back({static_cast<int>(array.pins.size()), ring, position});
  }
  array.ring_start.push_back(array.pins.size());
  return array;
}

}  // namespace

const PinArray& hedgehog_86() {
  static const PinArray array = make_hedgehog_86();
  return array;
}

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
