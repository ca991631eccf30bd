// SPDX-License-Identifier: MIT
// The watchdog's checks of currents, fan and board: trip conditions and tolerated readings.
#include <gtest/gtest.h>

#include <cmath>

#include "daemon/control/checks/board_check.h"
#include "daemon/control/checks/current_check.h"
#include "daemon/control/checks/fan_check.h"
#include "model/tick.h"

namespace hedgehog::control {
namespace {

TEST(CurrentCheck, AnIdleWindingMayCarryHalfAnAmpere) {
  CurrentCheck check{model::CoilModel{}};
  CurrentReading reading;
  reading.fresh = reading.follows = true;
  reading.current_a = {0.5, -0.5, 0.0};
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(check.step(reading), Reason::kNone);
  reading.current_a = {0.0, 0.0, -0.52};
  int ticks = 1;
  while (check.step(reading) == Reason::kNone && ticks < 100) ++ticks;
  EXPECT_EQ(ticks, 15);
}

TEST(CurrentCheck, FollowsEveryDriveWithLAndROff) {
  for (const double l_off : {0.8, 1.0, 1.2}) {
    for (const double t : {15.0, 70.0}) {
      for (const double hz : {0.5, 10.0, 60.0, 170.0, 250.0}) {
        for (const int delay : {0, 2, 4}) {
          CurrentCheck check{model::CoilModel{}};
          const double r = 0.45 * (1.0 + 0.00393 * (t - 25.0));
          const double keep = std::exp(-r * model::kTickSeconds / (1.5e-3 * l_off));
          std::array<double, 8> volts{};
          double current = 0.0;
          for (int i = 0; i < 5000; ++i) {
            const double phase = std::fmod(i * model::kTickSeconds * hz, 1.0);
            // Full swing at the supply's limit.
            const double commanded = phase < 0.5 ? 12.0 : (phase < 0.6 ? -12.0 : 0.0);
            volts[static_cast<std::size_t>(i % 8)] = std::clamp(commanded, -7.0, 7.0);
            const double applied = volts[static_cast<std::size_t>((i + 8 - delay) % 8)];
            current = keep * current + (1.0 - keep) * applied / r;
            CurrentReading reading;
            reading.fresh = reading.follows = true;
            reading.current_a.x = current;
            reading.applied_v.x = applied;
            reading.commanded_v.x = volts[static_cast<std::size_t>(i % 8)];
            ASSERT_EQ(name(check.step(reading)), "none")
                << "L x " << l_off << ", " << t << " C, " << hz << " Hz, delay " << delay;
          }
        }
      }
    }
  }
}

TEST(CurrentCheck, AHalvedMeasurementIsAMismatch) {
  CurrentCheck check{model::CoilModel{}};
  CurrentReading reading;
  reading.fresh = reading.follows = true;
  reading.applied_v = reading.commanded_v = {2.25, 0, 0};
  Reason reason = Reason::kNone;
  double current = 0.0;
  int ticks = 0;
  for (; reason == Reason::kNone && ticks < 200; ++ticks) {
    reason = check.step(reading);
    current += (5.0 - current) * 0.26;
    reading.current_a.x = 0.5 * current;
  }
  EXPECT_EQ(name(reason), "current_mismatch");
  EXPECT_LT(ticks, 60);
}

// For a vibration, a halved measurement is within the tolerance for recent commands; it contradicts
// the duty applied in the same millisecond.
TEST(CurrentCheck, AHalvedMeasurementOfAVibrationIsAMismatch) {
  CurrentCheck check{model::CoilModel{}};
  CurrentReading reading;
  reading.fresh = reading.follows = true;
  Reason reason = Reason::kNone;
  double current = 0.0;
  for (int tick = 0; reason == Reason::kNone && tick < 2000; ++tick) {
    reading.applied_v.x = reading.commanded_v.x = tick % 10 < 5 ? 5.0 : 0.0;
    current = 0.728 * current + 0.272 * reading.applied_v.x / 0.476;
    reading.current_a.x = 0.5 * current;
    reason = check.step(reading);
  }
  EXPECT_EQ(name(reason), "current_mismatch");
}

// A board that deviates from its command, and reports it correctly.
TEST(CurrentCheck, ADutyThatWasNeverCommandedIsAMismatch) {
  CurrentCheck check{model::CoilModel{}};
  CurrentReading reading;
  reading.fresh = reading.follows = true;
  reading.commanded_v = {2.25, 0, 0};
  reading.applied_v = {6.75, 0, 0};
  Reason reason = Reason::kNone;
  double current = 0.0;
  int ticks = 0;
  for (; reason == Reason::kNone && ticks < 200; ++ticks) {
    current = 0.728 * current + 0.272 * reading.applied_v.x / 0.476;
    reading.current_a.x = current;
    reason = check.step(reading);
  }
  EXPECT_EQ(name(reason), "current_mismatch");
  EXPECT_LT(ticks, 30);
}

// Frames from before a freeze of the host arrive first: they are no fault of the board.
TEST(CurrentCheck, OldFramesAfterALongGapAreNoFault) {
  CurrentCheck check{model::CoilModel{}};
  CurrentReading reading;
  reading.fresh = reading.follows = true;
  reading.applied_v = reading.commanded_v = reading.held_v = {2.38, 0, 0};
  reading.current_a = {5.0, 0, 0};
  for (int i = 0; i < 50; ++i) check.step(reading);
  reading.skipped = 2000;
  reading.since_s = 0.02;
  reading.commanded_v = {};
  for (int i = 0; i < 15; ++i) {
    ASSERT_EQ(name(check.step(reading)), "none") << i;
    reading.skipped = 0;
    reading.since_s = model::kTickSeconds;
    reading.held_v = {};
  }
}

// Each frame counts for the time since the last one, and no single frame trips.
TEST(CurrentCheck, LostFramesDoNotStopTheClock) {
  CurrentCheck check{model::CoilModel{}};
  CurrentReading reading;
  reading.fresh = true;
  reading.current_a = {0.0, 3.0, 0.0};
  reading.since_s = 0.004;
  int frames = 1;
  while (check.step(reading) == Reason::kNone && frames < 100) ++frames;
  EXPECT_EQ(frames, 4);
  check = CurrentCheck{model::CoilModel{}};
  reading.since_s = 0.02;
  frames = 1;
  while (check.step(reading) == Reason::kNone && frames < 100) ++frames;
  EXPECT_EQ(frames, 3);
}

TEST(FanCheck, ThreeSecondsWithoutATurn) {
  FanCheck check;
  for (int i = 0; i < 10'000; ++i)
    ASSERT_EQ(check.step(false, 0.0, model::kTickSeconds), Reason::kNone);
  for (int i = 0; i < 2999; ++i)
    ASSERT_EQ(check.step(true, 0.0, model::kTickSeconds), Reason::kNone);
  EXPECT_EQ(name(check.step(true, 0.0, model::kTickSeconds)), "fan_stopped");
  check.reset();
  for (int i = 0; i < 2000; ++i)
    ASSERT_EQ(check.step(true, 0.0, model::kTickSeconds), Reason::kNone);
  check.step(true, 400.0, model::kTickSeconds);
  for (int i = 0; i < 2999; ++i)
    ASSERT_EQ(check.step(true, 0.0, model::kTickSeconds), Reason::kNone);
}

TEST(BoardCheck, AliveUntilAHundredTicksOfSilence) {
  BoardCheck check;
  EXPECT_FALSE(check.alive());
  check.step(true, true, {}, 1);
  EXPECT_TRUE(check.alive());
  for (int i = 0; i < 99; ++i) {
    check.step(true, false, {}, 1);
    ASSERT_TRUE(check.alive()) << i;
  }
  check.step(true, false, {}, 1);
  EXPECT_FALSE(check.alive());
  check.step(false, true, {}, 1);
  EXPECT_FALSE(check.alive()) << "present is a condition of its own";
}

}  // namespace
}  // namespace hedgehog::control
