// SPDX-License-Identifier: MIT
// Positions of a ball's pins. Frame: x front (the arrow on the casing), y left, z up, right-handed.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::model {

struct Pin {
  int id = 0;     // index in PinArray::pins
  int ring = 0;   // 0 is the top pin; each further ring touches the one above it
  Vec3 position;  // unit vector from the centre of the ball; the axis along which the pin moves
};

struct NearestPin {
  int id = 0;
  double cosine = 0.0;  // of the angle to the requested direction: its fraction of the force
};

/// Immutable after start-up; any thread.
struct PinArray {
  std::string arrangement;  // name in device files and `device.describe`
  /// Ring by ring from the top; in each ring anticlockwise seen from above, beginning at the front.
  std::vector<Pin> pins;
  std::vector<std::size_t> ring_start;  // first id of each ring; one entry more than rings

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
/// ones. A hedgehog-86 has none straight down: the nearest have a cosine of about 0.79. RT-safe.
NearestPin nearest_pin(const PinArray& array, const Vec3& direction) noexcept;

/// Pin pitch on the ball of the thesis: 2 cm (section 3.2: 10 pins a second are 20 cm/s).
inline constexpr double kThesisPitchDeg = 23.5;

/// Pin pitch of another ball: scaled by the median angle between nearest pins, rounded to 0.01. At
/// most 120; kThesisPitchDeg with fewer than two pins.
double pin_pitch_deg(const PinArray& array);

}  // namespace hedgehog::model
