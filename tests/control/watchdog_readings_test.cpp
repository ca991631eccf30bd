// SPDX-License-Identifier: MIT
// What the watchdog passes to its checks: times, skipped ticks, accuracies, and which currents
// determine a resistance.
#include <gtest/gtest.h>

#include <tuple>
#include <utility>

#include "tests/control/watched.h"
#include "tests/rig/rig.h"

namespace hedgehog::control {
namespace {

/// Frames of `every` ticks until the ball trips, at most 1000.
int frames_until_trip(Watched& ball, model::Tick every) {
  for (int frame = 1; frame <= 1000; ++frame) {
    ball.fresh = false;
    for (model::Tick i = 1; i < every; ++i) ball.step();
    ball.fresh = true;
    if (ball.step() != Reason::kNone) return frame;
  }
  return 0;
}

Watched with_stopped_fan() {
  Watched ball;
  ball.commanded.fan = 255;
  ball.board.fan_rpm = 0.0;
  return ball;
}

TEST(WatchdogReadings, AFrameCountsForTheTimeSinceTheLastUpToTwentyMilliseconds) {
  for (const auto& [every, frames] : {std::pair{1, 3000}, {10, 300}, {20, 150}, {25, 150}}) {
    Watched ball = with_stopped_fan();
    ball.step();
    int trip = 0;
    for (int k = 0; k < 4 && trip == 0; ++k) {
      const int found = frames_until_trip(ball, every);
      trip = found == 0 ? 0 : 1000 * k + found;
    }
    EXPECT_NEAR(trip, frames, 1) << every;
  }
}

TEST(WatchdogReadings, TheSmallestFanDutyIsACommandToTurn) {
  Watched ball = with_stopped_fan();
  ball.commanded.fan = 1;
  EXPECT_EQ(name(ball.run(3100)), "fan_stopped");
  ball = with_stopped_fan();
  ball.commanded.fan = 0;
  EXPECT_EQ(name(ball.run(3100)), "none");
}

TEST(WatchdogReadings, AGapOfTheLoopCountsAsTwentyMilliseconds) {
  Watched ball = with_stopped_fan();
  int steps = 1;
  while (ball.step(25) == Reason::kNone && steps < 1000) ++steps;
  EXPECT_EQ(steps, 150);
}

TEST(WatchdogReadings, AFanCoolsAfterHalfASecondOfTelemetry) {
  for (const int every : {1, 10, 20}) {
    Watched ball;
    ball.board.fan_duty = 1.0;
    ball.board.fan_rpm = model::ThermalModel{}.fan_full_rpm;
    ball.step();
    int ms = 0;
    for (; !ball.watchdog.fan().cooling() && ms < 5000; ++ms) {
      ball.fresh = ms % every == every - 1;
      ball.step();
    }
    EXPECT_NEAR(ms, 500, every) << every;
    ball.fresh = false;
    ball.run(95);
    EXPECT_TRUE(ball.watchdog.fan().cooling()) << every;
    ball.run(10);
    EXPECT_FALSE(ball.watchdog.fan().cooling()) << every;
  }
}

TEST(WatchdogReadings, AHotThermistorCountsForTheTimeSinceTheLastFrame) {
  Watched ball;
  ball.board.sensor_c = 69.0;
  ball.step();
  ball.board.sensor_c = 71.0;
  EXPECT_EQ(frames_until_trip(ball, 10), 5);
}

TEST(WatchdogReadings, ACurrentCountsForTheTimeSinceTheLastFrame) {
  Watched ball;
  ball.step();
  ball.board.current_a = {0.0, 0.0, 2.0};
  EXPECT_EQ(frames_until_trip(ball, 4), 4);
}

TEST(WatchdogReadings, TheExpectedCurrentFollowsTheCommandThroughSkippedTicks) {
  const Watched goal = driven({0, 12, 0}, 1.0);
  Watched ball = driven({}, 1.0);
  ball.run(100);
  ball.commanded = goal.commanded;
  ball.board.current_a = goal.board.current_a;
  ball.board.duty = goal.board.duty;
  for (int i = 0; i < 8; ++i) {
    ball.board.sequence += 18;
    EXPECT_EQ(name(ball.step(19)), "none") << i;
  }
}

TEST(WatchdogReadings, ACurrentIsComparedWithTheBoardsOwnDutyToo) {
  Watched ball = driven({0, 9, 0}, 1.0);
  EXPECT_EQ(name(ball.run(100)), "none");
  ball.board.duty = (6.0 / 9.0) * ball.board.duty;
  ball.board.supply_current_known = false;
  EXPECT_EQ(name(ball.run(100)), "current_mismatch");
}

TEST(WatchdogReadings, WhatBrakingBridgesReturnIsNotExpectedOfTheSupply) {
  Watched ball = driven({0, 12, 0}, 1.0);
  const auto duty = ball.board.duty;
  const double supply_a = ball.board.supply_current_a;
  for (int i = 0; i < 3000; ++i) {
    const bool brakes = i % 4 == 3;
    ball.board.duty = brakes ? -1.0 * duty : duty;
    ball.board.supply_current_a = brakes ? 0.0 : supply_a;
    ball.step();
    ASSERT_FALSE(ball.watchdog.disagreement().any()) << i;
  }
}

TEST(WatchdogReadings, APartOfTheSumBelowAnAmpereExcludesTheCurrentToo) {
  Watched ball = driven({0, 4.5, 0}, 1.0);
  ASSERT_LT(ball.board.supply_current_a, 1.0);
  ball.run(1000);
  EXPECT_EQ(ball.watchdog.supply().moved(1, 0.1, SupplyBalance::Since::kFile),
            (Disagreement{1, Quantity::kResistance, Quantity::kHeatBalance}));
}

TEST(WatchdogReadings, TheSupplyIsComparedWithinTheBoardsAccuracy) {
  for (const auto& [accuracy, reason] : {std::pair{model::kInLineAccuracy, "measurements_disagree"},
                                         {model::kDriverCsAccuracy, "none"}}) {
    Watched ball = driven({0, 12, 0}, 0.94);
    ball.board.accuracy = accuracy;
    EXPECT_EQ(name(ball.run(10'000)), reason);
  }
}

/// A rested ball of 25 C whose windings carry 4 A, with a reference of each winding at 8 A.
struct Referenced : Watched {
  explicit Referenced(const model::CurrentAccuracy& accuracy) : Watched(driven({8, 8, 8}, 1.0)) {
    watchdog.start_rested();
    board.thermistors = 3;
    board.thermistor.fill({device::ThermistorState::kRead, 25.0});
    board.accuracy = accuracy;
    board.supply_current_known = false;
    EXPECT_EQ(name(run(800)), "none");
    const Watched weaker = driven({4, 4, 4}, 1.0);
    commanded = weaker.commanded;
    board.current_a = weaker.board.current_a;
    board.duty = weaker.board.duty;
    EXPECT_EQ(name(run(300)), "none");
  }
  /// V/I of winding x gives `celsius`.
  void show(double celsius) {
    const model::Ohms ohm = model::resistance_at(model::Ohms(0.45), model::Celsius(celsius));
    board.duty.x = ohm.value * board.current_a.x / board.supply_v;
  }
};

TEST(WatchdogReadings, VIIsHotByMoreThanTheErrorOfTheBoardsCurrents) {
  for (const auto& [accuracy, shown_c, reason] :
       {std::tuple{model::kInLineAccuracy, 76.0, "overheated"},
        {model::kDriverCsAccuracy, 76.0, "none"},
        {model::kDriverCsAccuracy, 88.0, "overheated"}}) {
    Referenced ball(accuracy);
    ball.show(shown_c);
    EXPECT_EQ(name(ball.run(200)), reason) << shown_c;
  }
}

TEST(WatchdogReadings, CurrentsThatChangeDirectionWithoutSignsDetermineNoResistance) {
  for (const int kept : {10, 100}) {
    Referenced ball(model::kDriverCsAccuracy);
    ball.show(90.0);
    ball.commanded = {};
    Reason found = Reason::kNone;
    for (int i = 1; i < 1000 && found != Reason::kOverheated; ++i) {
      found = ball.step();
      if (i % kept == 0) {
        ball.board.current_a = -1.0 * ball.board.current_a;
        ball.board.duty = -1.0 * ball.board.duty;
      }
    }
    EXPECT_EQ(found == Reason::kOverheated, kept == 100) << kept;
  }
}

TEST(WatchdogReadings, AThermistorIsComparedWithVIWithinTheErrorOfTheCurrents) {
  // 4 A with the drivers' own sensors measure a winding within 5 K, which is not compared.
  for (const auto& [accuracy, reason] : {std::pair{model::kInLineAccuracy, "sensor_disagrees"},
                                         {model::kDriverCsAccuracy, "none"}}) {
    Referenced ball(accuracy);
    Reason found = Reason::kNone;
    double shown_c = 25.0;
    while (found == Reason::kNone && shown_c < 45.0) {
      shown_c += 0.01;
      ball.board.thermistor.fill({device::ThermistorState::kRead, shown_c});
      found = ball.run(5);
    }
    EXPECT_EQ(name(found), reason);
    EXPECT_GT(shown_c, 25.0 + ThermistorCheck::kDisagreeK + 1.0) << "the error of V/I is tolerated";
  }
}

/// A ball of whose `count` thermistors that of winding `coil` shows `celsius` after a while.
Watched with_thermistors(int count, int coil, double celsius) {
  Watched ball;
  ball.board.thermistors = count;
  for (device::Thermistor& one : ball.board.thermistor)
    one = {device::ThermistorState::kRead, 25.0};
  ball.run(100);
  ball.board.thermistor[static_cast<std::size_t>(coil)].celsius = celsius;
  return ball;
}

TEST(WatchdogReadings, TheThermistorOfEachWindingIsChecked) {
  for (const int sensor_winding : {0, 1, 2})
    for (const int coil : {0, 1, 2}) {
      Watched ball = with_thermistors(3, coil, 25.0);
      model::ThermalModel thermal;
      thermal.sensor_winding = sensor_winding;
      ball.watchdog = Watchdog(model::CoilModel{}, thermal);
      ball.run(100);
      ball.board.thermistor[static_cast<std::size_t>(coil)].celsius = 35.0;
      const Reason reason = ball.run(25);
      if (coil == sensor_winding) {
        EXPECT_EQ(name(reason), "sensor_jump");
        continue;
      }
      EXPECT_EQ(name(reason), "measurements_disagree");
      EXPECT_EQ(ball.watchdog.disagreement(),
                (Disagreement{coil, Quantity::kThermistor, Quantity::kHeatBalance}));
      EXPECT_EQ(name(ball.watchdog.arming_blocker()), "sensor_jump");
    }
}

TEST(WatchdogReadings, OnlyTheThermistorsOfTheBoardAreChecked) {
  Watched two = with_thermistors(2, 1, 35.0);
  EXPECT_EQ(name(two.run(25)), "measurements_disagree");
  EXPECT_EQ(name(two.watchdog.arming_blocker()), "sensor_jump");
  EXPECT_EQ(name(with_thermistors(2, 2, 35.0).run(2000)), "none");
  Watched one = with_thermistors(1, 1, 35.0);
  EXPECT_EQ(name(one.run(2000)), "none");
  EXPECT_EQ(name(one.watchdog.arming_blocker()), "none");
}

TEST(WatchdogReadings, ASingleThermistorIsComparedWithItsOwnWindingOnly) {
  rig::RigOptions options;
  options.board.front_end.thermistors = 1;
  options.board.plant.sensor_winding = 1;
  options.control.thermal.sensor_winding = 1;
  rig::Rig rig(options);
  rig.run_until_armed();
  const auto effect = rig.start(rig::hold({1, 0, 0}, 12.0));
  for (int second = 0; second < 20; ++second) {
    rig.update(effect, rig::hold({1, 0, 0}, 12.0));
    rig.run(1000);
  }
  EXPECT_GT(rig.plant().heat().winding_c[0], 40.0);
  EXPECT_EQ(name(rig.controller().state()), "armed") << name(rig.controller().reason());
}

TEST(WatchdogReadings, AWarmerThermistorAndAnUnarmedBallDoNotTrip) {
  EXPECT_EQ(name(with_thermistors(3, 2, 28.0).run(200)), "none");
  Watched unarmed = with_thermistors(3, 2, 35.0);
  unarmed.armed = false;
  EXPECT_EQ(name(unarmed.run(200)), "none");
}

TEST(WatchdogReadings, AThermistorThatIsImplausibleOrNoLongerSentIsLost) {
  Watched implausible = with_thermistors(3, 2, -25.0);
  EXPECT_EQ(name(implausible.run(50)), "measurements_disagree");
  Watched missing = with_thermistors(3, 2, 25.0);
  missing.board.thermistor[2].state = device::ThermistorState::kNone;
  EXPECT_EQ(name(missing.run(990)), "none");
  EXPECT_EQ(name(missing.run(20)), "measurements_disagree");
  EXPECT_EQ(missing.watchdog.disagreement().coil(), 2);
}

}  // namespace
}  // namespace hedgehog::control
