// SPDX-License-Identifier: MIT
#include "clients/racer/game/driver.h"

#include <algorithm>
#include <cmath>

#include "clients/racer/game/car.h"
#include "clients/racer/game/laps.h"
#include "clients/racer/game/race.h"

namespace hedgehog::racer {

namespace {

constexpr double kSideways = 11.0;  // m/s^2, maximum lateral acceleration in a bend
constexpr double kBraking = 7.0;    // m/s^2, assumed deceleration
constexpr double kMaxSpeed = 18.0;
constexpr double kTimeoutS = 1.0;
constexpr double kReverseS = 1.2;

const Vec3& point(const std::vector<Vec3>& centre, std::size_t i) {
  return centre[i % centre.size()];
}

/// 1/m, from three points 6 m apart.
double bend(const std::vector<Vec3>& centre, std::size_t at) {
  const Vec3 before = point(centre, at + 3) - point(centre, at);
  const Vec3 after = point(centre, at + 6) - point(centre, at + 3);
  const double turn = std::atan2(cross(before, after).z, dot(before, after));
  return std::abs(turn) / std::max(norm(before), 0.1);
}

/// The speed that every bend of the next 60 m allows.
double allowed_speed(const std::vector<Vec3>& centre, std::size_t at) {
  double allowed = kMaxSpeed;
  for (std::size_t k = 0; k < 30; ++k) {
    const double there = kSideways / std::max(bend(centre, at + k), 1e-3);
    allowed = std::min(allowed, std::sqrt(there + 2.0 * kBraking * 2.0 * static_cast<double>(k)));
  }
  return allowed;
}

}  // namespace

Controls Driver::drive(const Scene& scene, const Track& track) {
  if (track.centre.empty()) return {};
  const std::size_t here = nearest_point(track.centre, scene.car.position);
  const double reach = 5.0 + 0.35 * std::max(scene.speed_mps, 0.0);
  const Vec3 goal = point(track.centre, here + static_cast<std::size_t>(reach / 2.0));
  const Vec3 local = rotate(conjugate(scene.car.orientation), goal - scene.car.position);
  // The arc from here through the goal (pure pursuit).
  const double arc = 2.0 * local.y / std::max(dot(local, local), 1.0);
  const double wheels = local.x > 0.0 ? std::atan(2.0 * kAxleX * arc) : std::copysign(1.0, local.y);
  const double steer = std::clamp(-wheels / steering_lock(scene.speed_mps), -1.0, 1.0);
  if (reverse_steps_ > 0) {
    --reverse_steps_;
    return {.steer = -steer, .throttle = 0.0, .brake = 1.0};
  }
  stuck_steps_ = std::abs(scene.speed_mps) < 0.7 ? stuck_steps_ + 1 : 0;
  if (stuck_steps_ > static_cast<int>(kTimeoutS / Race::kStepS)) {
    stuck_steps_ = 0;
    reverse_steps_ = static_cast<int>(kReverseS / Race::kStepS);
  }
  const double more = allowed_speed(track.centre, here) - scene.speed_mps;
  return {.steer = steer,
          .throttle = std::clamp(0.5 * more, 0.0, 1.0),
          .brake = std::clamp(-0.3 * more, 0.0, 1.0)};
}

}  // namespace hedgehog::racer
