// SPDX-License-Identifier: MIT
// A recorded path plays back within its error bound.
#include "clients/ctl/patterns/path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "model/effect/keyframes.h"
#include "model/quaternion.h"

namespace hedgehog::client {
namespace {

using model::Vec3;

/// The angle between the played path and `point`, at the same time.
double playback_error_deg(const SimplifiedPath& path, const PathPoint& point) {
  std::vector<model::Keyframe> frames;
  for (const protocol::Keyframe& frame : path.keyframes) {
    const Vec3 d = model::unit_or(std::get<Vec3>(*frame.direction), {1, 0, 0});
    frames.push_back({static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z),
                      1.0F, static_cast<std::uint16_t>(frame.t_ms), model::Ease::kLinear});
  }
  const Vec3 plays = model::point_at(frames, static_cast<double>(point.t_ms)).direction;
  return std::atan2(norm(cross(plays, point.direction)), dot(plays, point.direction)) * 180.0 /
         std::numbers::pi;
}

std::vector<PathPoint> turning_evenly(double deg_per_s, std::int64_t until_ms) {
  std::vector<PathPoint> points;
  for (std::int64_t t = 0; t <= until_ms; t += 10)
    points.push_back(
        {t, model::rotate(model::axis_angle({0, 0, 1}, deg_per_s * static_cast<double>(t) / 1000.0),
                          {1, 0, 0})});
  return points;
}

TEST(Path, AnEvenTurnNeedsTwoKeyFrames) {
  const SimplifiedPath path = simplify_path(turning_evenly(45.0, 2000), 1.0, 0.7);
  ASSERT_EQ(path.keyframes.size(), 2u);
  EXPECT_EQ(path.keyframes[1].t_ms, 2000);
  EXPECT_EQ(path.keyframes[1].level, 0.7);
  EXPECT_LT(path.error_deg, 0.05);
}

TEST(Path, APauseOnTheWayIsKept) {
  auto points = turning_evenly(45.0, 1000);
  const Vec3 rest = points.back().direction;
  for (std::int64_t t = 1010; t <= 2000; t += 10) points.push_back({t, rest});
  const SimplifiedPath path = simplify_path(points, 1.0, 1.0);
  EXPECT_EQ(path.keyframes.size(), 3u);
  for (const PathPoint& point : points) EXPECT_LE(playback_error_deg(path, point), 1.05);
}

TEST(Path, APointAloneIsOneKeyFrame) {
  EXPECT_EQ(simplify_path({{0, {0, 1, 0}}}, 1.0, 1.0).keyframes.size(), 1u);
}

RC_GTEST_PROP(Path, PlaysBackWithinTheReportedError, ()) {
  const double tolerance_deg = *rc::gen::inRange(1, 20) / 2.0;
  const int steps = *rc::gen::inRange(2, 600);
  std::vector<PathPoint> points;
  Vec3 at{1, 0, 0};
  for (int i = 0; i < steps; ++i) {
    const auto component = [] { return *rc::gen::inRange(-100, 101) / 1000.0; };
    at = model::unit_or(at + Vec3{component(), component(), component()}, {0, 0, 1});
    points.push_back({i * 10, at});
  }
  const SimplifiedPath path = simplify_path(points, tolerance_deg, 1.0);
  RC_ASSERT(path.keyframes.size() <= 256u);
  RC_ASSERT(path.error_deg <= tolerance_deg || path.keyframes.size() == 256u);
  for (const PathPoint& point : points)
    RC_ASSERT(playback_error_deg(path, point) <= path.error_deg + 0.05);
}

}  // namespace
}  // namespace hedgehog::client
