// SPDX-License-Identifier: MIT
// A ball described by data: any Goldberg array, any removed pins, any front.
#include "model/magnets/ball_geometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/magnets/force_curve.h"

namespace hedgehog::model {
namespace {

using testing::HasSubstr;

/// Magnets that fit any array.
BallGeometry small_magnets(std::string arrangement) {
  BallGeometry geometry;
  geometry.arrangement = std::move(arrangement);
  geometry.sizes = {{1.0, 2.0}, {0.5, 2.0}, 60.0};
  return geometry;
}

double azimuth_of(const Vec3& v) {
  const double degrees = std::atan2(v.y, v.x) * 180.0 / std::numbers::pi;
  return degrees < -1e-4 ? degrees + 360.0 : std::max(degrees, 0.0);
}

std::string error_of(const BallGeometry& geometry) {
  const auto ball = ball_pins(geometry);
  return ball.has_error() ? ball.error().message : "";
}

TEST(BallGeometry, IsTheBallOfTheThesisByDefault) {
  const auto ball = ball_pins({}).value();
  EXPECT_EQ(ball.get(), &thesis_ball());
  EXPECT_EQ(ball->array.pins.size(), 86u);
  EXPECT_EQ(ball->curves.size(), 86u);
}

TEST(BallGeometry, OtherMagnetsOnTheSamePinsMoveThemDifferently) {
  BallGeometry weaker;
  weaker.sizes.shield.diameter_mm = 3.5;
  const auto ball = ball_pins(weaker).value();
  ASSERT_EQ(ball->array.pins.size(), 86u);
  for (std::size_t i = 0; i < 86; ++i)
    EXPECT_EQ(ball->array.pins[i].position, thesis_ball().array.pins[i].position);
  EXPECT_NE(ball->curves.rest_mm(0), thesis_ball().curves.rest_mm(0));
}

// Pins are numbered ring by ring from the top, anticlockwise from the front, also with removed
// pins.
RC_GTEST_PROP(BallGeometry, AnyArrayWithAnyFrontAndPinsRemovedAnywhere, ()) {
  const auto name = *rc::gen::element<std::string>("cD", "wD", "tkD", "GP(2,2)", "tkD-86");
  BallGeometry geometry = small_magnets(name);
  const auto whole = arrangement_named(name).value();
  const auto pin = [&] { return *rc::gen::inRange(1, static_cast<int>(whole.pins.size()) - 1); };
  geometry.front_pin = pin();
  geometry.removed_pins = *rc::gen::unique<std::vector<int>>(
      rc::gen::inRange(0, static_cast<int>(whole.pins.size()) - 2));
  const auto front = std::find_if(whole.pins.begin(), whole.pins.end(),
                                  [&](const auto& site) { return site.id == geometry.front_pin; });
  RC_PRE(front != whole.pins.end());
  RC_PRE(std::hypot(front->direction.x, front->direction.y) > 1e-3);

  const Arrangement ball = arrangement_of(geometry).value();
  RC_ASSERT(ball.pins.size() == whole.pins.size() - geometry.removed_pins.size());
  for (std::size_t i = 0; i < ball.pins.size(); ++i) {
    const MagnetSite& here = ball.pins[i];
    RC_ASSERT(here.id == static_cast<int>(i));
    if (i == 0) continue;
    const MagnetSite& before = ball.pins[i - 1];
    RC_ASSERT(before.ring <= here.ring);
    if (before.ring == here.ring)
      RC_ASSERT(azimuth_of(before.direction) < azimuth_of(here.direction));
  }
  const bool front_is_there = std::find(geometry.removed_pins.begin(), geometry.removed_pins.end(),
                                        geometry.front_pin) == geometry.removed_pins.end();
  const auto faces_front = [&](const MagnetSite& site) {
    return site.ring == front->ring && azimuth_of(site.direction) < 1e-4;
  };
  RC_ASSERT(!front_is_there || std::any_of(ball.pins.begin(), ball.pins.end(), faces_front));
}

TEST(BallGeometry, RingsThatAreEmptyHaveNoPins) {
  BallGeometry geometry = small_magnets("cD");
  geometry.removed_pins = {1, 2, 3, 4, 5};  // the whole ring below the top
  geometry.front_pin = 6;
  const auto ball = ball_pins(geometry).value();
  EXPECT_EQ(ball->array.ring(0).size(), 1u);
  EXPECT_TRUE(ball->array.ring(1).empty());
  EXPECT_EQ(ball->array.ring(2).front().id, 1);
  EXPECT_EQ(ball->array.pins.size(), 37u);
}

// With one pin removed, every pin is a class of its own: 410 000 pairs, but few distinct angles.
TEST(BallGeometry, WithoutSymmetryHasTheCurvesThatAreComputedPinByPin) {
  BallGeometry geometry = small_magnets("tkD");
  geometry.removed_pins = {40};
  const Arrangement arrangement = arrangement_of(geometry).value();
  const auto classes = symmetry_classes(arrangement);
  ASSERT_GT(classes.size(), 40u);
  constexpr ForceSettings kFine{ForceModel::kExact, 1e-4};
  constexpr OffsetGrid kGrid{0.0, 1.5, 0.5};
  const auto curves = force_curves(classes, geometry.sizes, kFine, kGrid);
  ASSERT_EQ(curves.size(), classes.size());
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const ForceCurve alone = force_curve({classes[c], geometry.sizes, kFine}, kGrid);
    for (std::size_t i = 0; i < alone.force_n.size(); ++i)
      EXPECT_NEAR(curves[c].force_n[i], alone.force_n[i], 1e-4 * std::abs(alone.force_n[i]) + 1e-9);
  }
}

TEST(BallGeometry, ImpossibleGeometriesAreReported) {
  EXPECT_THAT(error_of(small_magnets("tkD-85")), HasSubstr("unknown array 'tkD-85'"));
  BallGeometry geometry = small_magnets("cD");
  geometry.removed_pins = {42};
  EXPECT_EQ(error_of(geometry), "there is no pin 42 to remove");
  geometry.removed_pins = {41, 17, 41};
  EXPECT_EQ(error_of(geometry), "pin 41 is removed twice");
  geometry = small_magnets("cD");
  geometry.front_pin = 42;
  EXPECT_EQ(error_of(geometry), "there is no pin 42 to be the front");
  geometry.front_pin = 0;
  EXPECT_EQ(error_of(geometry), "pin 0 is at a pole and shows no front");
  geometry = {};
  geometry.arrangement = "GP(4,1)";
  EXPECT_THAT(error_of(geometry), HasSubstr("overlap by"));
}

}  // namespace
}  // namespace hedgehog::model
