// SPDX-License-Identifier: MIT
// What `hedgehogctl calibrate` makes of the sides that windings push, and of a faulty winding.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "clients/ctl/calibrate/calibration.h"

namespace hedgehog::client {
namespace {

TEST(Pushed, EachWindingOnAnAxisOfItsOwn) {
  const auto sides = read_pushed({"x=back", "y=up", "z=left"});
  ASSERT_TRUE(sides);
  const auto matrix = coil_matrix(*sides);
  ASSERT_TRUE(matrix);
  // Column by column: the currents for a field to the front, to the left, to the top.
  EXPECT_EQ((*matrix)[0], (model::Vec3{-1, 0, 0}));
  EXPECT_EQ((*matrix)[1], (model::Vec3{0, 0, 1}));
  EXPECT_EQ((*matrix)[2], (model::Vec3{0, 1, 0}));
  EXPECT_TRUE(read_pushed({}));
  EXPECT_FALSE(coil_matrix({}));
  for (const char* wrong : {"x=back", "x", "x=", "w=up", "x=sideways", "x:up"})
    EXPECT_FALSE(read_pushed({wrong})) << wrong;
  EXPECT_FALSE(read_pushed({"x=front", "y=back", "z=up"}));
}

TEST(Pushed, AnswersMayBeAbbreviated) {
  for (const char* answer : {"left", "Left", " l", "LE\r", "lef "})
    EXPECT_EQ(side_meant(answer), "left") << answer;
  for (const char* answer : {"", " ", "lft", "lefty", "x", "up down", "-"})
    EXPECT_EQ(side_meant(answer), "") << answer;
}

TEST(Pushed, TwoOnOneAxisAndLeftHandedAxesAreDetected) {
  EXPECT_EQ(same_axis({{"left", "front", "right"}}, 2), 0u);
  EXPECT_EQ(same_axis({{"left", "front", "up"}}, 2), std::nullopt);
  EXPECT_EQ(same_axis({{"left", "", ""}}, 0), std::nullopt);
  EXPECT_FALSE(is_left_handed({{"front", "left", "up"}}));
  EXPECT_FALSE(is_left_handed({{"left", "back", "up"}})) << "only turned";
  EXPECT_TRUE(is_left_handed({{"left", "front", "up"}})) << "two swapped";
  EXPECT_TRUE(is_left_handed({{"front", "left", "down"}})) << "one turned";
  EXPECT_FALSE(is_left_handed({}));
}

TEST(WindingProblem, IsNamedWithARemedy) {
  using testing::HasSubstr;
  constexpr std::array<double, 3> kForth{0.3, 0.04, 0.0};
  constexpr std::array<double, 3> kBack{-0.3, 0.04, 0.0};
  EXPECT_EQ(winding_problem(0, kForth, kBack, 0.45), "") << "a sensor's constant error is none";
  EXPECT_THAT(winding_problem(1, kForth, kBack, 4.0), HasSubstr("winding y: when it is driven"));
  EXPECT_THAT(winding_problem(1, kForth, kBack, 4.0), HasSubstr("measured in x; compare"));
  EXPECT_THAT(winding_problem(2, {0.001, 0, 0}, {}, std::nullopt), HasSubstr("check its plug"));
  EXPECT_THAT(winding_problem(0, kBack, kForth, -0.45), HasSubstr("other way round"));
  EXPECT_THAT(winding_problem(0, kForth, kBack, 0.04), HasSubstr("0.04 ohm"));
}

}  // namespace
}  // namespace hedgehog::client
