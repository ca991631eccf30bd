// SPDX-License-Identifier: MIT
#include "model/geometry/direction.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "model/magnets/ball_geometry.h"
#include "tests/model/direction_named.h"

namespace hedgehog::model {
namespace {

void expect_near(const Vec3& got, const Vec3& expected) {
  EXPECT_NEAR(norm(got - expected), 0.0, 1e-12);
}

TEST(Direction, NamesAreXForwardYLeftZUp) {
  EXPECT_EQ(direction_named("front"), (Vec3{1, 0, 0}));
  EXPECT_EQ(direction_named("back"), (Vec3{-1, 0, 0}));
  EXPECT_EQ(direction_named("left"), (Vec3{0, 1, 0}));
  EXPECT_EQ(direction_named("right"), (Vec3{0, -1, 0}));
  EXPECT_EQ(direction_named("up"), (Vec3{0, 0, 1}));
  EXPECT_EQ(direction_named("down"), (Vec3{0, 0, -1}));
}

TEST(Direction, OtherWordsAreInvalid) {
  for (const char* word : {"", "Left", "forward", "lef", "left ", "north"})
    EXPECT_EQ(direction_named(word), std::nullopt) << word;
}

TEST(Direction, AzimuthRunsAnticlockwiseSeenFromAbove) {
  expect_near(vector_of({0, 0}), {1, 0, 0});
  expect_near(vector_of({90, 0}), {0, 1, 0});
  expect_near(vector_of({180, 0}), {-1, 0, 0});
  expect_near(vector_of({-90, 0}), {0, -1, 0});
  expect_near(vector_of({270, 0}), {0, -1, 0});
  expect_near(vector_of({123, 90}), {0, 0, 1});
  expect_near(vector_of({0, -90}), {0, 0, -1});
  expect_near(vector_of({0, 45}), {std::sqrt(0.5), 0, std::sqrt(0.5)});
}

TEST(Direction, PolesAndTheZeroVectorHaveAzimuthZero) {
  EXPECT_EQ(angles_of({0, 0, 3}).azimuth_deg, 0.0);
  EXPECT_NEAR(angles_of({0, 0, 3}).elevation_deg, 90.0, 1e-12);
  EXPECT_NEAR(angles_of({0, 0, -3}).elevation_deg, -90.0, 1e-12);
  EXPECT_EQ(angles_of({}).elevation_deg, 0.0);
}

TEST(Direction, SidesForPeople) {
  for (const NamedDirection& d : kNamedDirections) {
    EXPECT_EQ(side_name(d.vector), d.name);
    const NearestPin pin = nearest_pin(thesis_ball().array, d.vector);
    EXPECT_EQ(side_name(thesis_ball().array.find(pin.id)->position), d.name);
  }
  EXPECT_EQ(side_name({1, -3, 2}), "right");
  EXPECT_EQ(side_name({}), "up");
}

RC_GTEST_PROP(Direction, AnglesAndVectorsAreInverse, ()) {
  const double azimuth = *rc::gen::inRange(-179'999, 180'000) * 1e-3;
  const double elevation = *rc::gen::inRange(-89'900, 89'900) * 1e-3;
  const AzimuthElevation back = angles_of(5.0 * vector_of({azimuth, elevation}));
  RC_ASSERT(std::abs(back.azimuth_deg - azimuth) < 1e-9);
  RC_ASSERT(std::abs(back.elevation_deg - elevation) < 1e-9);
}

}  // namespace
}  // namespace hedgehog::model
