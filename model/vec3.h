// SPDX-License-Identifier: MIT
// Plain vectors of three doubles. Trivially copyable, so that they can be passed to the control
// thread and recorded byte for byte (Eigen's fixed vectors are not).
#pragma once

#include <cmath>

namespace hedgehog::model {

struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  constexpr double operator[](int axis) const noexcept { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double& operator[](int axis) noexcept { return axis == 0 ? x : axis == 1 ? y : z; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) noexcept = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator-(const Vec3& a) noexcept { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double k, const Vec3& a) noexcept { return {k * a.x, k * a.y, k * a.z}; }
constexpr Vec3 operator*(const Vec3& a, double k) noexcept { return k * a; }

constexpr double dot(const Vec3& a, const Vec3& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(const Vec3& a, const Vec3& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vec3& a) noexcept { return std::sqrt(dot(a, a)); }
inline bool is_finite(const Vec3& a) noexcept {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// The unit vector along `a`; `fallback` when `a` is shorter than 1e-12 or not finite.
inline Vec3 unit_or(const Vec3& a, const Vec3& fallback) noexcept {
  const double length = norm(a);
  return std::isfinite(length) && length > 1e-12 ? (1.0 / length) * a : fallback;
}

/// Three rows. `m * v` is the usual product.
struct Mat3 {
  Vec3 row[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  friend constexpr bool operator==(const Mat3& a, const Mat3& b) noexcept {
    return a.row[0] == b.row[0] && a.row[1] == b.row[1] && a.row[2] == b.row[2];
  }
};

constexpr Vec3 operator*(const Mat3& m, const Vec3& v) noexcept {
  return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)};
}
constexpr double determinant(const Mat3& m) noexcept {
  return dot(m.row[0], cross(m.row[1], m.row[2]));
}

/// The inverse. REQUIRES: determinant(m) != 0.
constexpr Mat3 inverse(const Mat3& m) noexcept {
  const double k = 1.0 / determinant(m);
  const Vec3 c0 = k * cross(m.row[1], m.row[2]);
  const Vec3 c1 = k * cross(m.row[2], m.row[0]);
  const Vec3 c2 = k * cross(m.row[0], m.row[1]);
  return {{{c0.x, c1.x, c2.x}, {c0.y, c1.y, c2.y}, {c0.z, c1.z, c2.z}}};
}

}  // namespace hedgehog::model
