// SPDX-License-Identifier: MIT
// Tilting the ball moves the axes of a stick.
#include "clients/gamepad/tilt_axes.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>

namespace hedgehog::gamepad {
namespace {

using model::axis_angle;
using model::Vec3;

/// Up in the frame of a ball that was rotated by `angle_deg` about `axis` of the world frame.
Vec3 up_after(const Vec3& axis, double angle_deg) {
  return rotate(conjugate(axis_angle(axis, angle_deg)), Vec3{0, 0, 1});
}
Vec3 tilted_right(double deg) { return up_after({1, 0, 0}, deg); }
Vec3 tilted_forward(double deg) { return up_after({0, 1, 0}, deg); }

class Tilt : public testing::Test {
 protected:
  explicit Tilt(const TiltOptions& options = {}) : axes_(options) { axes_.position({0, 0, 1}); }
  TiltAxes axes_;
};

TEST_F(Tilt, RightIsPositiveXAndForwardIsNegativeY) {
  EXPECT_EQ(axes_.position(tilted_right(40)), (StickPosition{kStickEnd, 0}));
  EXPECT_EQ(axes_.position(tilted_right(-40)), (StickPosition{-kStickEnd, 0}));
  EXPECT_EQ(axes_.position(tilted_forward(40)), (StickPosition{0, -kStickEnd}));
  EXPECT_EQ(axes_.position(tilted_forward(-40)), (StickPosition{0, kStickEnd}));
}

TEST_F(Tilt, IsZeroInTheDeadZoneAndContinuousAtItsEdge) {
  EXPECT_EQ(axes_.position(tilted_right(2.9)), StickPosition{});
  const auto position = axes_.position(tilted_right(3.1));
  EXPECT_GT(position.x, 0);
  EXPECT_LT(position.x, kStickEnd / 100);
}

TEST_F(Tilt, SaturatesAtItsEnd) { EXPECT_EQ(axes_.position(tilted_right(120)).x, kStickEnd); }

TEST_F(Tilt, TheCurveIsFineNearTheCentre) {
  TiltAxes even({.full_deg = 40, .dead_zone_deg = 0, .curve = 1});
  TiltAxes fine({.full_deg = 40, .dead_zone_deg = 0, .curve = 2});
  even.position({0, 0, 1});
  fine.position({0, 0, 1});
  EXPECT_NEAR(even.position(tilted_right(20)).x, kStickEnd / 2, 1);
  EXPECT_NEAR(fine.position(tilted_right(20)).x, kStickEnd / 4, 1);
}

TEST_F(Tilt, TheFirstPoseAndThatOfRecentreAreTheCentre) {
  TiltAxes axes({});
  EXPECT_EQ(axes.position(tilted_right(30)), StickPosition{});
  EXPECT_EQ(axes.position(tilted_right(70)).x, kStickEnd);
  axes.recentre();
  EXPECT_EQ(axes.position(tilted_forward(180)), StickPosition{});
}

RC_GTEST_PROP(TiltProperty, StaysOnItsDiscAndGrowsWithTheTilt, ()) {
  const double heading = *rc::gen::inRange(0, 360) * 3.14159265358979 / 180.0;
  const Vec3 axis{std::cos(heading), std::sin(heading), 0.0};
  TiltAxes axes({});
  axes.position({0, 0, 1});
  double before = 0.0;
  for (int deg = 0; deg <= 179; ++deg) {
    const auto position = axes.position(up_after(axis, deg));
    const double out = std::hypot(position.x, position.y);
    RC_ASSERT(out <= kStickEnd + 1.0);
    RC_ASSERT(out >= before - 1.0);
    before = out;
  }
}

}  // namespace
}  // namespace hedgehog::gamepad
