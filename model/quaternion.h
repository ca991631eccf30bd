// SPDX-License-Identifier: MIT
// Rotations as unit quaternions {w, x, y, z}, Hamilton convention, device -> world.
#pragma once

#include <cmath>

#include "model/vec3.h"

namespace hedgehog::model {

struct Quaternion {
  double w = 1.0;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  friend constexpr bool operator==(const Quaternion&, const Quaternion&) noexcept = default;
};

constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) noexcept {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
constexpr Quaternion conjugate(const Quaternion& q) noexcept { return {q.w, -q.x, -q.y, -q.z}; }
inline double norm(const Quaternion& q) noexcept {
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

/// `v` turned by the unit quaternion `q`: device -> world. The inverse is `rotate(conjugate(q),
/// v)`.
constexpr Vec3 rotate(const Quaternion& q, const Vec3& v) noexcept {
  const Vec3 u{q.x, q.y, q.z};
  const Vec3 t = 2.0 * cross(u, v);
  return v + q.w * t + cross(u, t);
}

/// Rotation by `angle_deg` about `axis`, counter-clockwise as seen against the axis. REQUIRES:
/// |axis| == 1.
inline Quaternion axis_angle(const Vec3& axis, double angle_deg) noexcept {
  const double half = angle_deg * (3.14159265358979323846 / 360.0);
  const double s = std::sin(half);
  return {std::cos(half), s * axis.x, s * axis.y, s * axis.z};
}

}  // namespace hedgehog::model
