// SPDX-License-Identifier: MIT
#include "clients/ctl/patterns/path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "model/effect/keyframes.h"
#include "model/magnets/arrangement.h"

namespace hedgehog::client {

namespace {

using model::Vec3;

/// Points between the key frames `first` and `last`; `worst` is the one with the largest error.
struct Part {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t worst = 0;
  double error_deg = 0.0;
  bool operator<(const Part& other) const noexcept { return error_deg < other.error_deg; }
};

/// Rounded as in the file: four decimals are 0.01 degrees.
Vec3 rounded(const Vec3& direction) {
  const auto round = [](double value) { return std::round(value * 1e4) / 1e4; };
  return {round(direction.x), round(direction.y), round(direction.z)};
}

model::Keyframe played(const PathPoint& point, std::int64_t from_ms) {
  const Vec3 direction = model::unit_or(rounded(point.direction), {1, 0, 0});
  return {static_cast<float>(direction.x),
          static_cast<float>(direction.y),
          static_cast<float>(direction.z),
          1.0F,
          static_cast<std::uint16_t>(point.t_ms - from_ms),
          model::Ease::kLinear};
}

Part part_of(const std::vector<PathPoint>& points, std::size_t first, std::size_t last) {
  Part part{first, last, first, 0.0};
  const std::int64_t from_ms = points[first].t_ms;
  const std::array<model::Keyframe, 2> ends{played(points[first], from_ms),
                                            played(points[last], from_ms)};
  for (std::size_t i = first + 1; i < last; ++i) {
    const auto at_ms = static_cast<double>(points[i].t_ms - from_ms);
    const double error =
        model::angle_deg(model::point_at(ends, at_ms).direction, points[i].direction);
    if (error <= part.error_deg) continue;
    part.error_deg = error;
    part.worst = i;
  }
  return part;
}

}  // namespace

SimplifiedPath simplify_path(const std::vector<PathPoint>& points, double tolerance_deg,
                             double level) {
  std::priority_queue<Part> parts;
  std::vector<std::size_t> kept{0};
  if (points.size() > 1) {
    kept.push_back(points.size() - 1);
    parts.push(part_of(points, 0, points.size() - 1));
  }
  while (!parts.empty() && parts.top().error_deg > tolerance_deg &&
         kept.size() < static_cast<std::size_t>(model::kMaxKeyframes)) {
    const Part part = parts.top();
    parts.pop();
    kept.push_back(part.worst);
    parts.push(part_of(points, part.first, part.worst));
    parts.push(part_of(points, part.worst, part.last));
  }
  std::sort(kept.begin(), kept.end());
  SimplifiedPath path;
  path.error_deg = parts.empty() ? 0.0 : parts.top().error_deg;
  for (const std::size_t i : kept)
    path.keyframes.push_back(
        {points[i].t_ms, rounded(points[i].direction), level, model::Ease::kLinear});
  return path;
}

}  // namespace hedgehog::client
