// SPDX-License-Identifier: MIT
#include "model/effect/keyframes.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::model {
namespace {

constexpr double kParallel = 1e-6;

/// `share` 0..1 of the way from `a` to `b` on the unit sphere.
Vec3 on_great_circle(const Vec3& a, const Vec3& b, double share) noexcept {
  const double cosine = std::clamp(dot(a, b), -1.0, 1.0);
  Vec3 across = b - cosine * a;
  if (norm(across) < kParallel) {
    if (cosine > 0.0) return a;
    const Vec3 up{0, 0, 1};
    const Vec3 front{1, 0, 0};
    const Vec3& over = std::abs(a.z) < 1.0 - kParallel ? up : front;
    across = over - dot(over, a) * a;
  }
  const double angle = share * std::acos(cosine);
  return std::cos(angle) * a + std::sin(angle) * unit_or(across, a);
}

double eased(Ease ease, double share) noexcept {
  switch (ease) {
    case Ease::kLinear:
      return share;
    case Ease::kStep:
      return 0.0;
    case Ease::kSmooth:
      return share * share * (3.0 - 2.0 * share);
  }
  return share;
}

}  // namespace

KeyframePoint point_at(std::span<const Keyframe> frames, double at_ms) noexcept {
  if (frames.empty()) return {};
  const auto next = std::upper_bound(frames.begin(), frames.end(), at_ms,
                                     [](double at, const Keyframe& k) { return at < k.t_ms; });
  if (next == frames.begin()) return {frames.front().direction(), 0.0};
  const Keyframe& from = *(next - 1);
  if (next == frames.end())
    return {from.direction(), at_ms > from.t_ms ? 0.0 : static_cast<double>(from.level)};
  const double share = eased(from.ease, (at_ms - from.t_ms) / (next->t_ms - from.t_ms));
  const double start = from.level;
  return {
      share > 0.0 ? on_great_circle(from.direction(), next->direction(), share) : from.direction(),
      start + share * (static_cast<double>(next->level) - start)};
}

double length_ms(std::span<const Keyframe> frames) noexcept {
  return frames.empty() ? 0.0 : frames.back().t_ms;
}

Quaternion turn_from_front(const Vec3& towards) noexcept {
  const Vec3 front{1, 0, 0};
  if (towards.x < -1.0 + 1e-9) return axis_angle({0, 0, 1}, 180.0);
  const Vec3 axis = cross(front, towards);
  const Quaternion q{1.0 + towards.x, axis.x, axis.y, axis.z};
  const double length = norm(q);
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

}  // namespace hedgehog::model
