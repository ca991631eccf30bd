// SPDX-License-Identifier: MIT
// Mounting of the sensor in the ball: the sensor sides that are the ball's front and top.
#pragma once

#include <cstdint>
#include <optional>

#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::device {

/// A side of a body with REP-103 axes: x front, y left, z up.
enum class Side : std::uint8_t { kFront, kBack, kLeft, kRight, kUp, kDown };

constexpr model::Vec3 normal(Side side) noexcept {
  switch (side) {
    case Side::kFront:
      return {1, 0, 0};
    case Side::kBack:
      return {-1, 0, 0};
    case Side::kLeft:
      return {0, 1, 0};
    case Side::kRight:
      return {0, -1, 0};
    case Side::kUp:
      return {0, 0, 1};
    case Side::kDown:
      return {0, 0, -1};
  }
  return {};
}

/// Trivially copyable; any thread.
class Mounting {
 public:
  /// Identity: the sensor's sides are the ball's.
  Mounting() noexcept = default;
  /// `front`, `up`: sides of the sensor that face the ball's front and up. nullopt if they are the
  /// same or opposite.
  static std::optional<Mounting> of(Side front, Side up) noexcept;

  /// Converts sensor -> world to ball -> world.
  model::Quaternion ball_to_world(const model::Quaternion& sensor_to_world) const noexcept {
    return sensor_to_world * ball_to_sensor_;
  }
  /// The same vector in the ball's axes.
  model::Vec3 to_ball(const model::Vec3& in_sensor) const noexcept {
    return rotate(conjugate(ball_to_sensor_), in_sensor);
  }

 private:
  model::Quaternion ball_to_sensor_;
};

}  // namespace hedgehog::device
