// SPDX-License-Identifier: MIT
#include "clients/racer/game/track.h"

#include <cmath>

#include "model/units.h"

namespace hedgehog::racer {

namespace {

constexpr double kSpacing = 2.0;
constexpr double kWallHeight = 1.0;
constexpr double kWallThickness = 0.5;

/// The Catmull-Rom spline between b and c.
Vec3 between(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double t) {
  return 0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                t * t * t * (3.0 * b - a - 3.0 * c + d));
}

/// Points about kSpacing apart, evenly spaced on the closed line through `fine`.
std::vector<Vec3> evenly(const std::vector<Vec3>& fine) {
  double length = 0.0;
  for (std::size_t i = 0; i < fine.size(); ++i)
    length += norm(fine[(i + 1) % fine.size()] - fine[i]);
  const auto count = static_cast<std::size_t>(length / kSpacing);
  const double spacing = length / static_cast<double>(count);
  std::vector<Vec3> points;
  double walked = 0.0;
  for (std::size_t i = 0; i < fine.size() && points.size() < count; ++i) {
    const Vec3 step = fine[(i + 1) % fine.size()] - fine[i];
    const double reach = norm(step);
    for (double at = spacing * static_cast<double>(points.size());
         at < walked + reach && points.size() < count;
         at = spacing * static_cast<double>(points.size()))
      points.push_back(fine[i] + ((at - walked) / reach) * step);
    walked += reach;
  }
  return points;
}

Wall wall_along(const Vec3& from, const Vec3& to) {
  const Vec3 middle = 0.5 * (from + to);
  const Vec3 along = to - from;
  // A little longer than the gap, so that the outside of a bend is closed.
  const Vec3 half{0.5 * norm(along) + 0.2, 0.5 * kWallThickness, 0.5 * kWallHeight};
  return {flat_pose(middle.x, middle.y, half.z,
                    std::atan2(along.y, along.x) * model::kDegreesPerRadian),
          half};
}

}  // namespace

Pose flat_pose(double x, double y, double z, double yaw_deg) {
  return {{x, y, z}, model::axis_angle({0, 0, 1}, yaw_deg)};
}

Track road_through(const std::vector<Vec3>& corners, double width) {
  std::vector<Vec3> fine;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < 50; ++k) {
      fine.push_back(between(corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n],
                             corners[(i + 2) % n], k / 50.0));
    }
  }
  Track track;
  track.width = width;
  track.centre = evenly(fine);
  const std::size_t count = track.centre.size();
  for (const double side : {-1.0, 1.0}) {
    std::vector<Vec3> edge;
    for (std::size_t i = 0; i < count; i += 2) {
      const Vec3 ahead =
          unit_or(track.centre[(i + 1) % count] - track.centre[(i + count - 1) % count], {1, 0, 0});
      const double out = side * 0.5 * (width + kWallThickness);
      edge.push_back(track.centre[i] + out * cross({0, 0, 1}, ahead));
    }
    for (std::size_t i = 0; i < edge.size(); ++i)
      track.walls.push_back(wall_along(edge[i], edge[(i + 1) % edge.size()]));
  }
  const Vec3 ahead = track.centre[1] - track.centre[0];
  track.start = flat_pose(track.centre[0].x, track.centre[0].y, 0.0,
                          std::atan2(ahead.y, ahead.x) * model::kDegreesPerRadian);
  return track;
}

}  // namespace hedgehog::racer
