// SPDX-License-Identifier: MIT
#include "clients/gamepad/tilt_axes.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::gamepad {

namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

/// The shortest rotation from `up` to (0, 0, 1).
model::Quaternion upright(const model::Vec3& up) {
  const double angle_deg = std::acos(std::clamp(up.z, -1.0, 1.0)) * kDegrees;
  const model::Vec3 axis{up.y, -up.x, 0.0};  // up x z
  const double length = std::hypot(axis.x, axis.y);
  if (length < 1e-9) return model::axis_angle({1, 0, 0}, angle_deg);
  return model::axis_angle({axis.x / length, axis.y / length, 0.0}, angle_deg);
}

}  // namespace

StickPosition TiltAxes::position(const model::Vec3& up) {
  if (!neutral_) neutral_ = upright(up);
  const model::Vec3 held = rotate(*neutral_, up);
  const double sideways = std::hypot(held.x, held.y);
  const double tilt_deg = std::atan2(sideways, held.z) * kDegrees;
  if (tilt_deg <= options_.dead_zone_deg || sideways < 1e-9) return {};
  const double beyond =
      (tilt_deg - options_.dead_zone_deg) / (options_.full_deg - options_.dead_zone_deg);
  const double out = kStickEnd * std::pow(std::min(1.0, beyond), options_.curve);
  return {static_cast<std::int32_t>(std::lround(out * held.y / sideways)),
          static_cast<std::int32_t>(std::lround(out * held.x / sideways))};
}

}  // namespace hedgehog::gamepad
