// SPDX-License-Identifier: MIT
// The board's own limits: each latches exactly at its boundary, and not a millisecond earlier.
#include <gtest/gtest.h>

#include "daemon/device/board_core/port.h"
#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

struct Limit : testing::Test {
  CoreBench bench;
  void SetUp() override {
    // Duties that can drive any current, so that none counts as unexpected.
    for (std::int16_t& duty : bench.set_point.duty_q15) duty = INT16_MAX;
    bench.arm_and_drive();
    ASSERT_TRUE(bench.drives());
  }
  // Latches by `fault` in exactly the `ms`-th millisecond from now.
  void expect_latch_after(int ms, Fault fault) {
    bench.run(ms - 1);
    EXPECT_TRUE(bench.drives()) << "too early";
    bench.run(1);
    EXPECT_TRUE(bench.latched_by(fault));
  }
};

TEST_F(Limit, OverCurrentLatchesAfterFiftyMilliseconds) {
  bench.inputs.current_ma[0] = 16501;
  expect_latch_after(50, kOverCurrent);
}

TEST_F(Limit, OverCurrentIsTheNormOfTheThree) {
  // 9527 * sqrt(3) = 16501.2; each alone is far below the limit.
  for (std::int16_t& current : bench.inputs.current_ma) current = -9527;
  expect_latch_after(50, kOverCurrent);
}

TEST_F(Limit, ExactlyTheLimitMayFlow) {
  bench.inputs.current_ma[2] = 16500;
  bench.run(500);
  EXPECT_TRUE(bench.drives());
}

TEST_F(Limit, AGapInTheOverCurrentRestartsTheCount) {
  for (int burst = 0; burst < 3; ++burst) {
    bench.inputs.current_ma[0] = 20000;
    bench.run(49);
    bench.inputs.current_ma[0] = 1000;
    bench.run(1);
  }
  EXPECT_TRUE(bench.drives());
}

TEST_F(Limit, TheLargestReadingsDoNotOverflow) {
  for (std::int16_t& current : bench.inputs.current_ma) current = INT16_MIN;
  expect_latch_after(50, kOverCurrent);
}

TEST_F(Limit, ASensorAboveSeventyFiveDegreesLatches) {
  bench.inputs.thermistor[0].cc = 7500;
  bench.run(500);
  EXPECT_TRUE(bench.drives());
  bench.inputs.thermistor[0].cc = 7501;
  expect_latch_after(50, kOverHeat);
}

TEST_F(Limit, AnOpenSensorLatches) {
  bench.inputs.thermistor[0].open = true;
  expect_latch_after(20, kSensorOpen);
}

TEST_F(Limit, AShortedSensorLatches) {
  bench.inputs.thermistor[0].shorted = true;
  expect_latch_after(20, kSensorShort);
}

TEST_F(Limit, TheReadingOfABrokenSensorIsNoTemperature) {
  bench.inputs.thermistor[0].open = true;
  bench.inputs.thermistor[0].cc = 30000;
  bench.run(1000);
  EXPECT_FALSE(bench.has(kOverHeat));
}

TEST_F(Limit, EachBridgeCanReportAFault) {
  for (int bridge = 0; bridge < kWindings; ++bridge) {
    CoreBench one;
    one.arm_and_drive();
    one.inputs.bridge_faults = static_cast<std::uint8_t>(1u << bridge);
    one.run(2);
    EXPECT_TRUE(one.drives());
    one.run(1);
    EXPECT_TRUE(one.latched_by(kBridge));
  }
}

TEST_F(Limit, TheSupplyMustBeInTheBridgesRange) {
  bench.inputs.supply_mv = 6500;
  bench.run(100);
  bench.inputs.supply_mv = 30000;
  bench.run(100);
  EXPECT_TRUE(bench.drives());
  bench.inputs.supply_mv = 30001;
  expect_latch_after(10, kSupply);
  CoreBench low;
  low.arm_and_drive();
  low.inputs.supply_mv = 6499;
  low.run(9);
  EXPECT_TRUE(low.drives());
  low.run(1);
  EXPECT_TRUE(low.latched_by(kSupply));
}

TEST_F(Limit, ANamedFaultIsReportedBesideTheDeadMan) {
  bench.inputs.thermistor[0].shorted = true;
  bench.run(20);
  bench.inputs.thermistor[0].shorted = false;
  bench.feeding = false;
  bench.run(500);
  EXPECT_TRUE(bench.latched_by(kSensorShort));
  EXPECT_FALSE(bench.has(kDeadMan)) << "a board that is not armed has nobody to miss";
}

// -- supply switch ------------------------------------------------------------------------------

struct SupplySwitch : testing::Test {
  CoreBench bench;
  void SetUp() override {
    bench.arm_and_drive();
    bench.inputs.current_ma[1] = 501;
    bench.set_point.enable = false;
    bench.run(1);  // asleep from here on
    ASSERT_FALSE(bench.drives());
  }
};

TEST_F(SupplySwitch, OpensWhenCurrentFlowsTwentyMillisecondsIntoSleep) {
  bench.run(19);
  EXPECT_TRUE(bench.outputs.supply_switch_closed);
  bench.run(1);
  EXPECT_FALSE(bench.outputs.supply_switch_closed);
  EXPECT_TRUE(bench.latched_by(kStuckBridge));
}

TEST_F(SupplySwitch, HalfAnAmpereIsAllowed) {
  bench.inputs.current_ma[1] = 500;
  bench.run(1000);
  EXPECT_TRUE(bench.outputs.supply_switch_closed);
}

TEST_F(SupplySwitch, CurrentWhileDrivingIsNotStuck) {
  bench.set_point.enable = true;
  bench.set_point.duty_q15[1] = 20'000;
  bench.inputs.current_ma[1] = 15000;
  bench.run(1000);
  EXPECT_TRUE(bench.outputs.supply_switch_closed);
  EXPECT_TRUE(bench.drives());
}

TEST_F(SupplySwitch, StaysOpenUntilArmed) {
  bench.run(20);
  bench.inputs.current_ma[1] = 0;
  bench.run(1000);
  EXPECT_FALSE(bench.outputs.supply_switch_closed);
  bench.arm_and_drive();
  EXPECT_TRUE(bench.outputs.supply_switch_closed);
}

struct SettledSupply : testing::Test {
  CoreBench bench{reference_limits()};
  SettledSupply() { bench.feeding = false; }
  bool closed_after(int ms, int supply_mv) {
    bench.inputs.supply_mv = static_cast<std::uint16_t>(supply_mv);
    bench.run(ms);
    return bench.outputs.supply_switch_closed;
  }
};

TEST_F(SettledSupply, TheSwitchWaitsForASupplyInRangeForTwentyMilliseconds) {
  EXPECT_FALSE(closed_after(1000, 0));
  EXPECT_FALSE(closed_after(1000, 6499));
  EXPECT_FALSE(closed_after(19, 6500));
  EXPECT_TRUE(closed_after(1, 6500));
}

TEST_F(SettledSupply, ATwentyFourVoltSupplyNeverClosesIt) {
  EXPECT_FALSE(closed_after(10'000, 24'000));
  EXPECT_TRUE(bench.has(kSupply));
  EXPECT_FALSE(bench.telemetry().supply_switch_closed);
  EXPECT_FALSE(closed_after(19, 18'000));
  EXPECT_FALSE(closed_after(1, 18'001)) << "the time begins anew";
  EXPECT_FALSE(closed_after(19, 18'000));
  EXPECT_TRUE(closed_after(1, 18'000));
}

TEST_F(SettledSupply, TooHighOpensItAfterTenMillisecondsTooLowDoesNot) {
  ASSERT_TRUE(closed_after(20, 12'000));
  EXPECT_TRUE(closed_after(1000, 0));
  EXPECT_TRUE(closed_after(20, 12'000));
  EXPECT_TRUE(closed_after(9, 18'001));
  EXPECT_FALSE(closed_after(1, 18'001));
}

TEST_F(SettledSupply, WithoutASettlingTimeItIsClosedAtPowerUp) {
  CoreBench simple;
  simple.feeding = false;
  simple.inputs.supply_mv = 0;
  simple.run(1);
  EXPECT_TRUE(simple.outputs.supply_switch_closed);
}

// -- tightening ---------------------------------------------------------------------------------

TEST_F(Limit, CanBeTightened) {
  bench.send(LimitsFrame{0, 6000, 8000, 500});
  bench.run(1);
  const TelemetryFrame telemetry = bench.telemetry();
  EXPECT_EQ(telemetry.sensor_limit_cc, 6000);
  EXPECT_EQ(telemetry.current_limit_ma, 8000);
  EXPECT_EQ(bench.core.limits().winding_a2s, BoardLimits{}.winding_a2s / 2);
  bench.inputs.current_ma[0] = 8001;
  expect_latch_after(50, kOverCurrent);
}

TEST_F(Limit, CanNeverBeLoosened) {
  bench.send(LimitsFrame{0, 6000, 8000, 500});
  bench.send(LimitsFrame{0, INT16_MAX, UINT16_MAX, UINT16_MAX});
  bench.run(1);
  EXPECT_EQ(bench.core.limits().sensor_cc, 6000);
  EXPECT_EQ(bench.core.limits().current_ma, 8000);
  EXPECT_EQ(bench.core.limits().winding_a2s, BoardLimits{}.winding_a2s / 2);
  EXPECT_EQ(bench.core.limits().device_a2s, BoardLimits{}.device_a2s / 2);
  bench.inputs.thermistor[0].cc = 6001;
  expect_latch_after(50, kOverHeat);
}

}  // namespace
}  // namespace hedgehog::board
