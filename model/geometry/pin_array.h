// SPDX-License-Identifier: MIT
// Positions of the pins of a ball. Frame: x towards the front (the arrow on the casing), y left, z
// up, right-handed.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::model {

struct Pin {
  /// Index in PinArray::pins.
  int id = 0;
  /// 0 is the top pin; each further ring touches the one above it.
  int ring = 0;
  /// Unit vector from the centre of the ball; the axis along which the pin moves.
  Vec3 position;
};

struct NearestPin {
  int id = 0;
  /// Cosine of the angle between the pin and the requested direction: its fraction of the force.
  double cosine = 0.0;
};

/// Immutable after start-up; any thread.
struct PinArray {
  /// Name of the arrangement in device files and `device.describe`.
  std::string arrangement;
  /// Ring by ring from the top; in each ring anticlockwise seen from above, beginning at the front.
  std::vector<Pin> pins;
  /// ring_start[r] is the first id of ring r; one entry more than rings.
  std::vector<std::size_t> ring_start;

  std::size_t rings() const noexcept { return ring_start.size() - 1; }
  /// REQUIRES: r < rings().
  std::span<const Pin> ring(std::size_t r) const noexcept {
    return std::span(pins).subspan(ring_start[r], ring_start[r + 1] - ring_start[r]);
  }
  /// nullptr if no pin has this id.
  const Pin* find(long long id) const noexcept {
    return id >= 0 && static_cast<std::size_t>(id) < pins.size()
               ? &pins[static_cast<std::size_t>(id)]
               : nullptr;
  }
};

/// The pin with the largest force by a field along `direction` (non-zero); the lowest id of equal
/// ones. A hedgehog-86 has no pin straight down: the nearest ones are at a cosine of about 0.79.
/// RT-safe.
NearestPin nearest_pin(const PinArray& array, const Vec3& direction) noexcept;

/// Pin pitch on the ball of the thesis, degrees: 2 cm (section 3.2: 10 pins a second are 20 cm/s).
inline constexpr double kThesisPitchDeg = 23.5;

/// Pin pitch of another ball, degrees: scaled by the median angle between nearest pins, rounded to
/// 0.01. At most 120; kThesisPitchDeg with fewer than two pins.
double pin_pitch_deg(const PinArray& array);

}  // namespace hedgehog::model
