// SPDX-License-Identifier: MIT
// An object thrown at the car is felt at the point of impact, with the strength of the impact.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "clients/racer/game/car.h"
#include "clients/racer/game/impacts.h"
#include "tests/racer/tracks.h"

namespace hedgehog::racer {
namespace {

class ThrownAtTheCar : public testing::TestWithParam<int> {};

TEST_P(ThrownAtTheCar, IsFeltOnThatSide) {
  const double azimuth_deg = 45.0 * GetParam();
  Race race(ball_thrown_from(azimuth_deg, 100.0, 12.0));
  const auto hits = drive<Hit>(race, 2.0, {});
  ASSERT_FALSE(hits.empty());
  EXPECT_LT(angle_deg(hits.front().what.direction, towards(azimuth_deg)), 20.0);
  // A central inelastic impact transfers m1 m2 / (m1 + m2) v; one that turns the car, less.
  const double max_impulse = 100.0 * kCarMassKg / (100.0 + kCarMassKg) * 12.0;
  EXPECT_GT(hits.front().what.impulse_n_s, 0.3 * max_impulse);
  EXPECT_LT(hits.front().what.impulse_n_s, 1.3 * max_impulse);
}

INSTANTIATE_TEST_SUITE_P(Eighths, ThrownAtTheCar, testing::Range(0, 8), [](const auto& eighth) {
  return std::to_string(45 * eighth.param) + "_deg";
});

TEST(Where, ACornerIs45DegreesAndAnImpactOnTheRoofIsUp) {
  const auto felt = [](const Vec3& point, const Vec3& surface) {
    return felt_direction({.body = 0, .point = point, .towards = surface, .impulse = 1.0});
  };
  const Vec3& half = kCarHalfSize;
  EXPECT_LT(angle_deg(felt({half.x, half.y, 0}, {1, 0, 0}), towards(45)), 0.01);
  EXPECT_LT(angle_deg(felt({-half.x, half.y, 0}, {0, 1, 0}), towards(135)), 0.01);
  // The whole left side against a wall.
  EXPECT_LT(angle_deg(felt({0, half.y, 0.3}, {0, 1, 0}), towards(90)), 0.01);
  EXPECT_LT(angle_deg(felt({1, 0.5, half.z}, {0, 0, 1}), {0, 0, 1}), 0.01);
  EXPECT_NEAR(norm(felt({1, 0.5, 0}, {0.6, 0, 0.8})), 1.0, 1e-9);
}

TEST(Impact, IsReportedAgainOnlyAfterTheContactOrMuchHarderOrOnAnotherSide) {
  const auto contact = [](double impulse, const Vec3& surface) {
    return std::vector<Contact>{
        {.body = Contact::kWalls, .point = surface, .towards = surface, .impulse = impulse}};
  };
  const Vec3 left{0, 1, 0};
  Impacts impacts;
  EXPECT_EQ(impacts.take(contact(500, left), 1.0).size(), 1U);
  for (int step = 1; step < 60; ++step)
    EXPECT_TRUE(impacts.take(contact(400, left), 1.0 + step / 60.0).empty()) << step;
  EXPECT_EQ(impacts.take(contact(1100, left), 2.0).size(), 1U);
  EXPECT_EQ(impacts.take(contact(500, {1, 0, 0}), 2.2).size(), 1U);
  EXPECT_TRUE(impacts.take(contact(500, {1, 0, 0}), 2.4).empty());
  EXPECT_EQ(impacts.take(contact(500, {1, 0, 0}), 2.7).size(), 1U);
  EXPECT_TRUE(impacts.take(contact(Impacts::kMinImpulse - 1, {1, 0, 0}), 5.0).empty());
}

TEST(Impact, GrowsWithTheSpeedAndTheMassOfTheObject) {
  double before = 0.0;
  for (const auto& [mass_kg, speed_mps] : {std::pair{50.0, 8.0}, {50.0, 16.0}, {150.0, 16.0}}) {
    Race race(ball_thrown_from(90.0, mass_kg, speed_mps));
    const auto hits = drive<Hit>(race, 2.0, {});
    ASSERT_FALSE(hits.empty());
    EXPECT_GT(hits.front().what.impulse_n_s, 1.5 * before);
    before = hits.front().what.impulse_n_s;
  }
}

TEST(Impact, AStandingCarHasNone) {
  Race race(open_ground());
  for (int i = 0; i < 120; ++i) {
    race.step({});
    EXPECT_TRUE(race.race_events().empty()) << i;
  }
  EXPECT_NEAR(race.scene().car.position.z, kCarStandsAt, 0.02);
}

TEST(Impact, AWallIsHitOnceAndScrapingIsNotReported) {
  // A long wall on the left, and the car is steered into it all the time.
  Track track = open_ground();
  track.walls.push_back({flat_pose(100, 3, 0.5, 0), {110, 0.25, 0.5}});
  Race race(track);
  const auto hits = drive<Hit>(race, 8.0, {.steer = -0.15, .throttle = 0.6});
  ASSERT_FALSE(hits.empty());
  EXPECT_GT(hits.front().what.direction.y, 0.5);
  EXPECT_LE(hits.size(), 4U);
  EXPECT_GT(race.scene().car.position.x, 30.0);
  EXPECT_LT(race.scene().car.position.y, 2.75);
}

}  // namespace
}  // namespace hedgehog::racer
