// SPDX-License-Identifier: MIT
// The simulated car: steering, skids on a slippery road, jumps, landings and rollovers, always with
// the same result.
#include <gtest/gtest.h>

#include <utility>

#include "clients/racer/best_lap.h"
#include "clients/racer/game/car.h"
#include "clients/racer/game/driver.h"
#include "clients/racer/game/laps.h"
#include "tests/racer/tracks.h"

namespace hedgehog::racer {
namespace {

TEST(Car, FollowsItsSteering) {
  for (const double steer : {-0.3, 0.3}) {
    Race race(open_ground());
    drive<Hit>(race, 3.0, {.steer = steer, .throttle = 0.5});
    EXPECT_GT(race.scene().speed_mps, 4.0);
    // Positive y is to the left.
    EXPECT_LT(steer * race.scene().car.position.y, -1.0);
  }
}

TEST(Car, BrakesAndThenReverses) {
  Race race(open_ground());
  drive<Hit>(race, 3.0, {.throttle = 1.0});
  const double fast = race.scene().speed_mps;
  drive<Hit>(race, 0.5, {.brake = 1.0});
  EXPECT_LT(race.scene().speed_mps, fast - 3.0);
  drive<Hit>(race, 5.0, {.brake = 1.0});
  EXPECT_LT(race.scene().speed_mps, -1.0);
}

TEST(Car, ClampsControlsToTheirRanges) {
  Race race(open_ground());
  race.step({.steer = -7, .throttle = 2, .brake = -1});
  EXPECT_EQ(race.scene().controls, (Controls{.steer = -1, .throttle = 1, .brake = 0}));
  race.step({.steer = std::nan(""), .throttle = 0, .brake = 0});
  EXPECT_EQ(race.scene().controls, Controls{});
}

/// Accelerates straight ahead, then coasts into a gentle bend; returns the largest skid.
double max_skid(const Track& track) {
  Race race(track);
  drive<Skid>(race, 3.0, {.throttle = 1.0});
  double max_amount = 0.0;
  for (const auto& skid : drive<Skid>(race, 1.0, {.steer = 0.15}))
    max_amount = std::max(max_amount, skid.what.amount);
  return max_amount;
}

TEST(Car, SkidsOnASlipperyPatchMoreThanOnTheDryRoad) {
  Track slippery = open_ground();
  slippery.patches.push_back({flat_pose(30, 0, 0, 0), 60, 40, 0.1});
  EXPECT_LT(max_skid(open_ground()), 0.2);
  EXPECT_GT(max_skid(slippery), 0.4);
}

TEST(Car, FliesOverARampAndLandsHarderFromAHigherOne) {
  double before = 0.0;
  for (const double height : {0.5, 1.2}) {
    Track track = open_ground();
    track.ramps.push_back({flat_pose(25, 0, 0, 0), 6, 5, height});
    Race race(track);
    const auto landings = drive<Landing>(race, 7.0, {.throttle = 1.0});
    ASSERT_FALSE(landings.empty()) << height;
    EXPECT_GT(landings.front().what.impulse_n_s, 1.2 * before);
    before = landings.front().what.impulse_n_s;
  }
}

/// A ramp under the wheels of one side, which turns the car over.
Track corkscrew() {
  Track track = open_ground();
  track.ramps.push_back({flat_pose(25, 0.9, 0, 0), 5, 1.4, 1.6});
  return track;
}

TEST(Car, TurnsOverWithARotatingGroundDirection) {
  Race race(corkscrew());
  const auto tumbles = drive<Tumble>(race, 6.0, {.throttle = 1.0});
  ASSERT_FALSE(tumbles.empty());
  double farthest = 0.0;
  for (const auto& [time_s, tumble] : tumbles) {
    EXPECT_NEAR(norm(tumble.down), 1.0, 1e-5);
    farthest = std::max(farthest, angle_deg(tumble.down, {0, 0, -1}));
  }
  // The direction sweeps: reported in every step, at most 12 degrees further each time.
  for (std::size_t i = 1; i < tumbles.size() && tumbles[i].time_s < tumbles[0].time_s + 0.5; ++i)
    EXPECT_LT(angle_deg(tumbles[i].what.down, tumbles[i - 1].what.down), 12.0);
  EXPECT_GT(farthest, 85.0);
}

TEST(Car, ThatLiesOnItsRoofIsReset) {
  Track track = open_ground();
  track.start.position.z = 0.5;
  track.start.orientation = model::axis_angle({1, 0, 0}, 180);
  Race race(track);
  EXPECT_FALSE(drive<Tumble>(race, 1.0, {}).empty());
  EXPECT_TRUE(drive<Landing>(race, 1.0, {}).empty());
  EXPECT_FALSE(drive<Reset>(race, 5.0, {}).empty());
}

TEST(Car, IsResetOntoTheRoadBeforeRampsAndObstacles) {
  const Track home = home_track();
  const Pose jump = home.ramps.front().pose;
  Track at_ramp = home;
  at_ramp.start = {jump.position + rotate(jump.orientation, {4, 0, 1}), jump.orientation};
  Track at_obstacle = home;
  at_obstacle.start = home.obstacles.front().pose;
  at_obstacle.start.position.z = 2.0;
  for (const Track& track : {at_ramp, at_obstacle}) {
    Race race(track);
    race.recover();
    EXPECT_NEAR(race.scene().car.position.z, kCarStandsAt, 1e-6);
    const Vec3 reset_to = race.scene().car.position;
    EXPECT_TRUE(drive<Hit>(race, 1.0, {}).empty());
    EXPECT_NEAR(race.scene().car.position.z, kCarStandsAt, 0.05);
    EXPECT_LT(norm(race.scene().car.position - reset_to), 0.2);
    EXPECT_LT(norm(reset_to - track.start.position), 15.0);
  }
}

struct Recorded {
  std::vector<std::pair<double, RaceEvent>> race_events;
  Scene end;
  friend bool operator==(const Recorded&, const Recorded&) = default;
};

Recorded record(Race& race, double seconds) {
  Recorded recorded;
  Driver driver;
  while (race.scene().time_s < seconds) {
    race.step(driver.drive(race.scene(), race.track()));
    for (const RaceEvent& race_event : race.race_events())
      if (!std::holds_alternative<Reset>(race_event))
        recorded.race_events.emplace_back(race.scene().time_s, race_event);
  }
  recorded.end = race.scene();
  return recorded;
}

template <class What>
std::vector<What> all(const Recorded& recorded) {
  std::vector<What> found;
  for (const auto& [time_s, race_event] : recorded.race_events)
    if (const auto* what = std::get_if<What>(&race_event)) found.push_back(*what);
  return found;
}

TEST(TheDriver, DrivesTheSameEveryTimeBitForBit) {
  Race race(home_track());
  const Recorded first = record(race, 40.0);
  EXPECT_GT(first.race_events.size(), 100U);
  Race other(home_track());
  EXPECT_EQ(record(other, 40.0), first);
}

TEST(TheDriver, FinishesFourLapsInTwoMinutesWithEveryEvent) {
  Race race(home_track());
  const Recorded recorded = record(race, 120.0);
  EXPECT_EQ(all<LapDone>(recorded).size(), 4U);
  EXPECT_GE(all<Landing>(recorded).size(), 4U);
  EXPECT_GT(all<Skid>(recorded).size(), 300U);
  int left = 0;
  int right = 0;
  int front = 0;
  int back = 0;
  for (const Hit& hit : all<Hit>(recorded)) {
    left += hit.direction.y > 0.5 ? 1 : 0;
    right += hit.direction.y < -0.5 ? 1 : 0;
    front += hit.direction.x > 0.9 ? 1 : 0;
    back += hit.direction.x < -0.5 ? 1 : 0;
  }
  EXPECT_GE(left, 4);
  EXPECT_GE(right, 4);
  EXPECT_GE(front, 2);
  EXPECT_GE(back, 2);
  EXPECT_EQ(recorded.end.lap, 5);
  EXPECT_LT(recorded.end.best_lap_s.value_or(99), 30.0);
}

TEST(TheDriver, BacksOutOfAWall) {
  Track track = home_track();
  // Across the road, with the front to the wall.
  track.start.orientation = model::axis_angle({0, 0, 1}, 90);
  track.start.position.y += 3.0;
  Race race(track);
  const Recorded recorded = record(race, 45.0);
  EXPECT_EQ(all<LapDone>(recorded).size(), 1U);
}

TEST(Lap, IsAFullRoundWithoutShortCuts) {
  const std::vector<Vec3> centre = home_track().centre;
  Laps round;
  Laps across;
  int rounds = 0;
  int crossings = 0;
  for (std::size_t i = 0; i <= centre.size(); ++i) {
    const Vec3& here = centre[i % centre.size()];
    rounds += round.take(centre, here) ? 1 : 0;
    // `across` takes a short cut past the second quarter of the track.
    if (i < centre.size() / 4 || i > centre.size() / 2)
      crossings += across.take(centre, here) ? 1 : 0;
  }
  EXPECT_EQ(rounds, 1);
  EXPECT_EQ(crossings, 0);
}

TEST(Lap, EndsAtTheFirstPointAfterAShortCutToo) {
  const std::vector<Vec3> centre = home_track().centre;
  const std::size_t count = centre.size();
  Laps laps;
  for (std::size_t i = 0; i < count; ++i) {
    if (i >= count / 4 && i <= count / 2) continue;
    EXPECT_FALSE(laps.take(centre, centre[i]));
  }
  EXPECT_FALSE(laps.take(centre, centre[0]));
  for (int lap = 1; lap <= 3; ++lap) {
    for (std::size_t i = 1; i < count; ++i) EXPECT_FALSE(laps.take(centre, centre[i])) << i;
    EXPECT_TRUE(laps.take(centre, centre[0]));
    EXPECT_EQ(laps.done(), lap);
  }
}

TEST(Lap, IsNotDrivenBackwards) {
  Track track = home_track();
  Race race(track);
  EXPECT_TRUE(drive<LapDone>(race, 6.0, {.brake = 1.0}).empty());
  // Crosses the line again, forwards.
  EXPECT_TRUE(drive<LapDone>(race, 4.0, {.throttle = 1.0}).empty());
  EXPECT_EQ(race.scene().lap, 1);
}

TEST(Lap, IsTimedFromTheFirstMovement) {
  Race race(home_track());
  drive<LapDone>(race, 3.0, {});
  EXPECT_EQ(race.scene().lap_time_s, 0.0);
  drive<LapDone>(race, 1.0, {.throttle = 1.0});
  EXPECT_NEAR(race.scene().lap_time_s, 1.0, 0.05);
  drive<LapDone>(race, 1.0, {});
  EXPECT_NEAR(race.scene().lap_time_s, 2.0, 0.05) << "letting go does not stop the clock";
}

TEST(BestLap, IsThatOfThePlayer) {
  BestLap best;
  best.drive(true);
  EXPECT_TRUE(best.by_driver());
  EXPECT_FALSE(best.finish(20.0)) << "the driver's";
  EXPECT_EQ(best.time_s(), std::nullopt);
  best.drive(false);
  EXPECT_TRUE(best.finish(40.0));
  best.drive(false);
  best.drive(true);
  best.drive(false);
  EXPECT_FALSE(best.finish(30.0)) << "the driver helped";
  best.drive(false);
  EXPECT_FALSE(best.finish(41.0));
  best.drive(false);
  EXPECT_TRUE(best.finish(39.0));
  EXPECT_EQ(best.time_s(), 39.0);
}

}  // namespace
}  // namespace hedgehog::racer
