// SPDX-License-Identifier: MIT
#include "clients/racer/game/tilt.h"

#include <algorithm>
#include <cmath>

#include "model/units.h"

namespace hedgehog::racer {

namespace {

using model::Vec3;

/// 0 within the dead zone, then linear to 1.
double share_of(double angle_deg) {
  const double beyond = std::abs(angle_deg) - kTiltDeadZoneDeg;
  const double share = std::clamp(beyond / (kTiltFullDeg - kTiltDeadZoneDeg), 0.0, 1.0);
  return std::copysign(share, angle_deg);
}

}  // namespace

Controls Tilt::controls(const model::Quaternion& ball) const noexcept {
  // Up in the device frame determines the tilt, independent of the heading.
  const Vec3 neutral = rotate(conjugate(neutral_), {0, 0, 1});
  const Vec3 up = rotate(conjugate(ball), {0, 0, 1});
  const Vec3 front = unit_or(Vec3{1, 0, 0} - neutral.x * neutral, {0, 0, 1});
  const Vec3 left = cross(neutral, front);
  const double upright = dot(up, neutral);
  const double forward = share_of(std::atan2(-dot(up, front), upright) * model::kDegreesPerRadian);
  const double right = share_of(std::atan2(dot(up, left), upright) * model::kDegreesPerRadian);
  return {.steer = right, .throttle = std::max(forward, 0.0), .brake = std::max(-forward, 0.0)};
}

}  // namespace hedgehog::racer
