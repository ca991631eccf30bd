// SPDX-License-Identifier: MIT
// The comparison of currents with commands: how long a difference is tolerated after an edge, and
// the size of a permitted permanent difference.
#include "daemon/control/checks/current_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hedgehog::control {
namespace {

// For a winding at 40 C, the check's assumption.
const double kOhm = model::resistance_at(model::Ohms(0.45), model::Celsius(40.0)).value;

struct Bench {
  CurrentCheck check{model::CoilModel{}};
  CurrentReading reading;

  Bench() { reading.fresh = true; }
  void command(double current_a) { reading.commanded_v.x = reading.held_v.x = current_a * kOhm; }
  Reason step(double measured_a) {
    reading.current_a.x = measured_a;
    const Reason reason = check.step(reading);
    reading.skipped = 0;
    return reason;
  }
  /// Follows the command until the current has settled.
  void settle(double current_a) {
    command(current_a);
    double measured_a = reading.current_a.x;
    for (int ms = 0; ms < 300; ++ms) {
      ASSERT_EQ(step(measured_a), Reason::kNone) << ms;
      measured_a += (current_a - measured_a) * 0.27;
    }
  }
  /// The tick in which it trips, and the reason; 0: not within 200.
  int trips_after(double measured_a, Reason& reason) {
    for (int ms = 1; ms <= 200; ++ms) {
      reason = step(measured_a);
      if (reason != Reason::kNone) return ms;
    }
    return 0;
  }
};

TEST(CurrentCheck, AWeaklyDrivenWindingMayCarryItsCurrentAndHalfAnAmpere) {
  Reason reason{};
  Bench weak;
  weak.settle(0.2);
  EXPECT_EQ(weak.trips_after(0.69, reason), 0);
  EXPECT_EQ(weak.trips_after(0.71, reason), 15);
  EXPECT_EQ(reason, Reason::kUnexpectedCurrent);
  Bench more;
  more.settle(0.3);
  EXPECT_EQ(more.trips_after(0.9, reason), 0) << "a quarter of an ampere is driven, not idle";
}

TEST(CurrentCheck, ADrivenWindingMayDifferByAnAmpereAndAFifth) {
  Reason reason{};
  for (const double sign : {1.0, -1.0}) {
    Bench bench;
    bench.settle(sign * 10.0);
    EXPECT_EQ(bench.trips_after(sign * 12.99, reason), 0);
    EXPECT_EQ(bench.trips_after(sign * 7.01, reason), 0);
    EXPECT_EQ(bench.trips_after(sign * 13.01, reason), 15);
    EXPECT_EQ(reason, Reason::kCurrentMismatch);
    Bench low;
    low.settle(sign * 10.0);
    EXPECT_EQ(low.trips_after(sign * 6.99, reason), 15);
    EXPECT_EQ(reason, Reason::kCurrentMismatch);
  }
}

TEST(CurrentCheck, ACurrentThatContinuesAfterADriveIsUnexpectedAfterTheEdge) {
  Bench bench;
  bench.settle(5.0);
  bench.command(0.0);
  Reason reason{};
  // 5 A fall below a quarter of an ampere in 5 ms ln 20 = 15 ms.
  EXPECT_EQ(bench.trips_after(2.0, reason), 15 + 15);
  EXPECT_EQ(reason, Reason::kUnexpectedCurrent);
}

TEST(CurrentCheck, TheLargerEndOfAnEdgeGivesTheTolerance) {
  for (const double sign : {1.0, -1.0}) {
    Bench bench;
    bench.command(sign * 10.0);
    for (int ms = 0; ms < 100; ++ms)
      ASSERT_EQ(name(bench.step(1.29 * bench.check.commanded_a().x)), "none") << ms;
  }
}

TEST(CurrentCheck, AnEdgeExcusesACurrentThatFollowsWithinTenMilliseconds) {
  for (const double from_a : {10.0, -10.0, 0.0}) {
    for (const double to_a : {10.0, -10.0, 0.0}) {
      Bench bench;
      bench.settle(from_a);
      bench.command(to_a);
      double measured_a = from_a;
      for (int ms = 0; ms < 200; ++ms) {
        ASSERT_EQ(name(bench.step(measured_a)), "none") << from_a << " to " << to_a << ", " << ms;
        measured_a += (to_a - measured_a) * (1.0 - std::exp(-0.1));
      }
    }
  }
}

TEST(CurrentCheck, AGapIsExcusedAsAnEdge) {
  Bench bench;
  bench.settle(5.0);
  bench.reading.skipped = 100;
  // The board's bridges fell asleep 20 ticks into the gap and are woken now.
  for (int ms = 0; ms < 17; ++ms) ASSERT_EQ(name(bench.step(0.0)), "none") << ms;
  for (int ms = 0; ms < 100; ++ms) ASSERT_EQ(name(bench.step(5.0)), "none") << ms;
}

// The current of before the gap is read for a while after it.
TEST(CurrentCheck, ADriveThatBeganJustBeforeAGapIsExcusedAfterIt) {
  Bench bench;
  bench.settle(0.0);
  bench.command(0.8);
  bench.step(0.0);
  bench.command(0.0);
  bench.reading.held_v.x = 0.8 * kOhm;
  bench.reading.skipped = 100;
  bench.reading.since_s = 0.02;
  for (int frame = 0; frame < 5; ++frame) ASSERT_EQ(name(bench.step(0.79)), "none") << frame;
}

TEST(CurrentCheck, InAGapTheLastSetPointIsHeldForNineteenTicks) {
  Bench bench;
  bench.settle(10.0);
  bench.reading.skipped = 19;
  bench.step(10.0);
  EXPECT_NEAR(bench.check.commanded_a().x, 10.0, 1e-6);
  bench.command(0.0);
  bench.reading.held_v.x = 10.0 * kOhm;
  bench.reading.skipped = 19 + 81;
  bench.step(10.0);
  EXPECT_NEAR(bench.check.commanded_a().x, 0.0, 1e-6);
}

TEST(CurrentCheck, IsPendingFromTheFirstMillisecondToTheLast) {
  Bench bench;
  bench.settle(0.0);
  EXPECT_FALSE(bench.check.pending());
  bench.step(0.6);
  EXPECT_TRUE(bench.check.pending());
  for (int ms = 0; ms < 10; ++ms) bench.step(0.0);
  EXPECT_FALSE(bench.check.pending());
}

TEST(CurrentCheck, AnUnmeasuredWindingIsNotChecked) {
  Bench bench;
  bench.settle(0.0);
  bench.reading.measured = {false, true, true};
  Reason reason{};
  EXPECT_EQ(bench.trips_after(9.0, reason), 0);
  EXPECT_FALSE(bench.check.pending());
}

}  // namespace
}  // namespace hedgehog::control
