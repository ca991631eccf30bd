// SPDX-License-Identifier: MIT
// Where the pins of a ball are. Frame: x towards the front (the arrow on the casing), y left, z up,
// right-handed.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::model {

struct Pin {
  /// Its place in PinArray::pins.
  int id = 0;
  /// 0 is the top pin; each further ring touches the one above it.
  int ring = 0;
  /// From the centre of the ball outwards, length 1: the way in which the pin moves.
  Vec3 position;
};

struct NearestPin {
  int id = 0;
  /// Cosine of the angle between the pin and what was asked for: its part of the force.
  double cosine = 0.0;
};

/// Immutable after start-up; any thread.
struct PinArray {
  /// As device files and `device.describe` call it.
  std::string arrangement;
  /// Ring by ring from the top; in each ring anticlockwise seen from above, beginning at the front.
  std::vector<Pin> pins;
  /// ring_start[r] is the first id of ring r; one more entry than there are rings.
  std::vector<std::size_t> ring_start;

  std::size_t rings() const noexcept { return ring_start.size() - 1; }
  /// REQUIRES: r < rings().
  std::span<const Pin> ring(std::size_t r) const noexcept {
    return std::span(pins).subspan(ring_start[r], ring_start[r + 1] - ring_start[r]);
  }
  /// nullptr when there is no such pin.
  const Pin* find(long long id) const noexcept {
    return id >= 0 && static_cast<std::size_t>(id) < pins.size()
               ? &pins[static_cast<std::size_t>(id)]
               : nullptr;
  }
};

/// The pin that a field along `direction` (any length but 0) pushes most; of equals the one of the
/// lowest id. On a hedgehog-86 there is none straight down, and the nearest are at a cosine of
/// about 0.79. RT-safe.
NearestPin nearest_pin(const PinArray& array, const Vec3& direction) noexcept;

/// From pin to pin on the ball of the thesis: 2 cm (section 3.2: 10 pins a second are 20 cm/s),
/// degrees.
inline constexpr double kThesisPitchDeg = 23.5;

/// The same on a ball with other pins: by as much more as the nearest pins are farther apart, in
/// the median of all pins; to 0.01 degrees. At most 120; that of the thesis with fewer than two
/// pins.
double pin_pitch_deg(const PinArray& array);

}  // namespace hedgehog::model
