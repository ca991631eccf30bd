// SPDX-License-Identifier: MIT
// Driving by tilting the ball: to the left and right it steers, forward is throttle, back is brake.
#pragma once

#include "clients/racer/game/controls.h"
#include "model/quaternion.h"

namespace hedgehog::racer {

/// Below this nothing happens: hands are never quite still.
inline constexpr double kTiltDeadZoneDeg = 4.0;
/// From here on it is all there is. People turn their wrists comfortably by 30 degrees.
inline constexpr double kTiltFullDeg = 30.0;

/// How the ball is held when the car shall roll straight on: turning it in the hands about the
/// vertical changes nothing.
class Tilt {
 public:
  /// As the ball is held now is neutral.
  void recentre(const model::Quaternion& ball) noexcept { neutral_ = ball; }
  /// `ball`: device -> world, as in `orientation.quaternion` of the status.
  Controls controls(const model::Quaternion& ball) const noexcept;

 private:
  model::Quaternion neutral_{};
};

}  // namespace hedgehog::racer
