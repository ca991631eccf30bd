// SPDX-License-Identifier: MIT
// Driving by tilting the ball: left and right steer, forward is throttle, back is brake.
#pragma once

#include "clients/racer/game/controls.h"
#include "model/quaternion.h"

namespace hedgehog::racer {

/// Dead zone for unsteady hands.
inline constexpr double kTiltDeadZoneDeg = 4.0;
/// Tilt of full deflection. People comfortably turn their wrists by 30 degrees.
inline constexpr double kTiltFullDeg = 30.0;

/// Stores the neutral orientation of the ball. A rotation about the vertical has no effect.
class Tilt {
 public:
  /// Makes the present orientation of the ball neutral.
  void recentre(const model::Quaternion& ball) noexcept { neutral_ = ball; }
  /// `ball`: device -> world, as in `orientation.quaternion` of the status.
  Controls controls(const model::Quaternion& ball) const noexcept;

 private:
  model::Quaternion neutral_{};
};

}  // namespace hedgehog::racer
