// SPDX-License-Identifier: MIT
// The board's slow comparison of the supply current with that of the windings, for current sensors
// that read low.
#include <gtest/gtest.h>

#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

constexpr int kForEverMs = 30'000;  // of a mean over 2 s

// One winding at full duty, so that the supply carries its current.
struct SupplyMean : testing::Test {
  SupplyMean() {
    bench.inputs.supply_current_measured = true;
    bench.set_point.duty_q15[0] = INT16_MAX;
    bench.arm_and_drive();
    bench.run(2);
  }
  static BoardLimits no_heat_limits() {
    BoardLimits limits;
    limits.winding_a2s = limits.device_a2s = 4'000'000'000u;
    return limits;
  }
  void flow(int measured_ma, int supply_ma) {
    bench.inputs.current_ma[0] = static_cast<std::int16_t>(measured_ma);
    bench.inputs.supply_ma = static_cast<std::uint16_t>(supply_ma);
  }
  /// Milliseconds until it latches; -1: it drives for ever.
  int latched_after_ms() {
    for (int ms = 1; ms <= kForEverMs; ++ms) {
      bench.run(1);
      if (bench.latched_by(kUnexpectedCurrent)) return ms;
      if (!bench.drives()) return -2;
    }
    return -1;
  }
  CoreBench bench{no_heat_limits()};
};

// Within 1 mA, to which the two means and the eighth are rounded down.
TEST_F(SupplyMean, AnEighthAndFourTenthsOfAnAmpereMoreMayFlowForEver) {
  flow(8000, 8000 + 1000 + 399);
  EXPECT_EQ(latched_after_ms(), -1);
}

TEST_F(SupplyMean, TwoMilliamperesBeyondThatLatchInTheEnd) {
  flow(8000, 8000 + 1000 + 402);
  EXPECT_GT(latched_after_ms(), 0);
}

TEST_F(SupplyMean, WhatNoWindingShowsLatchesFromFourTenthsOfAnAmpereOn) {
  flow(0, 400);
  EXPECT_EQ(latched_after_ms(), -1);
  flow(0, 401);
  EXPECT_GT(latched_after_ms(), 0);
}

// 8 A through 0.6 ohm draw 3.2 A from 12 V, of which 0.7 x 8 A at the same duty explain 2.24 A. The
// host has found the winding by then.
TEST_F(SupplyMean, ASensorThatReadsThirtyPercentLowAtEightAmperesLatchesWithinThreeSeconds) {
  flow(2240, 3200);
  const int ms = latched_after_ms();
  EXPECT_GT(ms, 1000);
  EXPECT_LT(ms, 3000);
}

TEST_F(SupplyMean, ASensorThatReadsTwentyPercentLowAtEightAmperesIsWithinTheTolerance) {
  flow(2560, 3200);
  EXPECT_EQ(latched_after_ms(), -1);
}

// The drivers' own sensors at the end of their accuracy (0.1 A and 2 %), on three windings at 5 A
// and 40 %, and the supply's (0.06 A and 2 %).
TEST_F(SupplyMean, TheSumOfAllTolerancesIsNoFault) {
  for (int k = 0; k < kWindings; ++k) {
    bench.set_point.duty_q15[k] = 4 * INT16_MAX / 10;
    bench.inputs.current_ma[k] = 5000 - 100 - 100;
  }
  bench.inputs.supply_ma = 6000 + 60 + 120;
  EXPECT_EQ(latched_after_ms(), -1);
}

TEST_F(SupplyMean, OneMillisecondOfALargeDifferenceIsNone) {
  for (int i = 0; i < 100; ++i) {
    flow(0, 10'000);
    bench.run(1);
    flow(8000, 8000);
    bench.run(99);
    ASSERT_TRUE(bench.drives()) << i;
  }
}

TEST_F(SupplyMean, AnUnmeasuredSupplyCurrentIsNotCompared) {
  bench.inputs.supply_current_measured = false;
  flow(0, 60'000);
  EXPECT_EQ(latched_after_ms(), -1);
}

// While the bridges sleep both means fall, whatever the supply line carries (another rule's).
TEST_F(SupplyMean, FallsWhileTheBridgesSleep) {
  for (int i = 0; i < 20; ++i) {
    flow(0, 1400);
    bench.run(400);
    ASSERT_TRUE(bench.drives()) << i;
    bench.set_point.enable = false;
    flow(0, 140);
    bench.run(3000);
    bench.set_point.enable = true;
  }
}

TEST_F(SupplyMean, OfABallThatSleepsAllowsArmingSoon) {
  flow(0, 1400);
  ASSERT_GT(latched_after_ms(), 0);
  bench.run(50);
  bench.request_arm();
  bench.run(2);
  EXPECT_TRUE(bench.drives());
}

TEST_F(SupplyMean, MoreThanTheConverterCanShowIsExpectedOfThreeWindings) {
  bench.set_point.duty_q15[1] = bench.set_point.duty_q15[2] = INT16_MAX;
  bench.run(2);
  for (int k = 0; k < kWindings; ++k) bench.inputs.current_ma[k] = 30'000;
  bench.inputs.supply_ma = UINT16_MAX;
  bench.run(20);
  EXPECT_FALSE(bench.has(kUnexpectedCurrent));
}

}  // namespace
}  // namespace hedgehog::board
