// SPDX-License-Identifier: MIT
// More current than the duties can drive, detected by the winding's own sensor or in the supply
// line.
#include <gtest/gtest.h>

#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

// 12 V x duty / 0.36 ohm, the resistance of the coldest winding at the lower tolerance.
int max_ma(std::int16_t duty_q15) { return static_cast<int>(12'000.0 * duty_q15 / 32767.0 / 0.36); }

struct Driving : CoreBench {
  Driving() {
    inputs.supply_current_measured = true;
    inputs.supply_ma = 3000;
    inputs.current_ma[0] = 6500;
    arm_and_drive();
    run(50);
  }
  /// Milliseconds until the board is safe; -1: not within 200.
  int safe_after_ms() {
    for (int ms = 0; ms < 200; ++ms) {
      if (latched_by(kUnexpectedCurrent)) return ms;
      run(1);
    }
    return -1;
  }
};

TEST(UnexpectedCurrent, InAWindingThatWasIdleEndsWithinTenMilliseconds) {
  Driving bench;
  ASSERT_TRUE(bench.drives());
  bench.inputs.current_ma[2] = -600;
  EXPECT_LE(bench.safe_after_ms(), 7);
  EXPECT_GE(bench.safe_after_ms(), 0);
}

TEST(UnexpectedCurrent, InAWindingThatShouldBeIdleNowEndsWithinThirtyMilliseconds) {
  Driving bench;
  bench.inputs.current_ma[0] = 15'000;
  bench.set_point.duty_q15[0] = 20'000;
  bench.run(20);
  ASSERT_TRUE(bench.drives());
  bench.set_point.duty_q15[0] = 0;
  bench.inputs.current_ma[0] = 2700;  // 10 % of the supply
  const int after_ms = bench.safe_after_ms();
  EXPECT_GE(after_ms, 0);
  EXPECT_LE(after_ms, 25);
}

TEST(UnexpectedCurrent, ThatDecaysInTheBrakeIsNone) {
  Driving bench;
  bench.set_point.duty_q15[0] = 20'000;
  bench.inputs.current_ma[0] = 15'000;
  bench.run(4);
  bench.set_point.duty_q15[0] = 0;
  double current_ma = 15'000.0;
  for (int ms = 0; ms < 100; ++ms) {
    bench.inputs.current_ma[0] = static_cast<std::int16_t>(current_ma);
    bench.inputs.supply_ma = 0;
    bench.run(1);
    ASSERT_TRUE(bench.drives()) << ms;
    current_ma *= 0.8;  // L / R of 4.5 ms
  }
}

TEST(UnexpectedCurrent, IsMoreThanTheDutyDrivesThroughTheMinimumResistance) {
  Driving bench;
  const int limit_ma = max_ma(bench.set_point.duty_q15[0]);
  bench.inputs.current_ma[0] = static_cast<std::int16_t>(limit_ma + 450);
  bench.run(100);
  EXPECT_TRUE(bench.drives());
  bench.inputs.current_ma[0] = static_cast<std::int16_t>(limit_ma + 600);
  EXPECT_GE(bench.safe_after_ms(), 0);
}

TEST(UnexpectedCurrent, IsFoundInTheSupplyLineWhenTheWindingsSensorFails) {
  Driving bench;
  bench.inputs.currents_measured = 1;
  bench.inputs.supply_ma = 3000 + 5000;
  const int after_ms = bench.safe_after_ms();
  EXPECT_GE(after_ms, 0);
  EXPECT_LE(after_ms, 25);
}

TEST(UnexpectedCurrent, InTheSupplyLineToleratesAnEighthAndAnAmpereAndAHalf) {
  Driving bench;
  // 6.5 A at 24.4 % draw 1.59 A.
  bench.inputs.supply_ma = 1590 + 198 + 1490;
  bench.run(200);
  EXPECT_TRUE(bench.drives());
}

TEST(UnexpectedCurrent, InOneMillisecondIsNone) {
  Driving bench;
  bench.inputs.current_ma[2] = 3000;
  bench.run(4);
  bench.inputs.current_ma[2] = 0;
  bench.run(10);
  EXPECT_TRUE(bench.drives());
}

TEST(UnexpectedCurrent, OfASleepingBridgeOpensTheSupplySwitchByTheSupplyLineToo) {
  Driving bench;
  bench.set_point.enable = false;
  bench.inputs.currents_measured = 0;
  bench.run(kChargingMs);
  bench.inputs.supply_ma = 270;  // 10 % of 2.7 A
  bench.run(30);
  EXPECT_TRUE(bench.latched_by(kStuckBridge));
  EXPECT_FALSE(bench.outputs.supply_switch_closed);
}

// A current that is not measured is assumed to decay as in the brake, and counts until it is 0.
TEST(UnmeasuredCurrent, CountsAsTheLastOneDecaying) {
  Driving bench;
  bench.inputs.supply_ma = 0;
  bench.set_point.duty_q15[0] = INT16_MAX;
  bench.run(20);
  bench.inputs.current_ma[0] = 19'000;
  const int half_ms = 45;
  // Every second millisecond is unmeasured: 19 A and then 14.25 A would not be 50 ms in a row.
  for (int ms = 0; ms < half_ms; ++ms) {
    bench.inputs.currents_measured = 7;
    bench.run(1);
  }
  ASSERT_FALSE(bench.has(kOverCurrent));
  bench.inputs.currents_measured = 6;
  bench.inputs.current_ma[0] = 0;
  bench.run(1);
  // 14.25 A: the count has started again, as it does for a measured current below the limit.
  bench.inputs.currents_measured = 7;
  bench.inputs.current_ma[0] = 19'000;
  bench.run(20);
  EXPECT_FALSE(bench.has(kOverCurrent));
  // The decaying current also exceeds a limit of 12 A.
  LimitsFrame tight;
  tight.sensor_cc = 7500;
  tight.current_ma = 12'000;
  tight.heat_permille = 1000;
  bench.send(tight);
  for (int ms = 0; ms < 60 && !bench.has(kOverCurrent); ++ms) {
    bench.inputs.currents_measured = ms % 2 == 0 ? 6 : 7;
    bench.run(1);
  }
  EXPECT_TRUE(bench.has(kOverCurrent));
}

// The wire of a driver's own sensor is disconnected: 0 V, far below its zero, is not a measurement.
TEST(UnmeasuredCurrent, OfAWindingDrivenInOneDirectionIsABrokenSensor) {
  Driving bench;
  bench.inputs.currents_measured = 6;
  bench.inputs.current_ma[0] = 0;
  bench.inputs.supply_ma = 0;
  bench.run(24);
  EXPECT_TRUE(bench.drives());
  bench.run(2);
  EXPECT_TRUE(bench.latched_by(kCurrentSense));
}

TEST(UnmeasuredCurrent, OfAWindingThatReversesIsNoFault) {
  Driving bench;
  bench.inputs.currents_measured = 6;
  bench.inputs.current_ma[0] = 0;
  bench.inputs.supply_ma = 0;
  for (int ms = 0; ms < 400; ++ms) {
    bench.set_point.duty_q15[0] = ms / 10 % 2 == 0 ? 8000 : -8000;
    bench.run(1);
  }
  EXPECT_TRUE(bench.drives());
}

}  // namespace
}  // namespace hedgehog::board
