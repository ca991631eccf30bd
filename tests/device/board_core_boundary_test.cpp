// SPDX-License-Identifier: MIT
// The boundary values of the current limits, exact to 1 mA and 1 ms.
#include <gtest/gtest.h>

#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

// Limits under which only one rule can trip: full duty at 6.5 V drives 18055 mA through 0.36 ohm.
constexpr std::int32_t kDrivenMa = 18'055;

BoardLimits no_other_limits() {
  BoardLimits limits;
  limits.current_ma = 60'000;
  limits.winding_a2s = limits.device_a2s = 4'000'000'000u;
  return limits;
}

struct FullDuty : CoreBench {
  explicit FullDuty(const BoardLimits& limits = no_other_limits()) : CoreBench(limits) {
    inputs.supply_mv = 6500;
    set_point.duty_q15[0] = INT16_MAX;
    arm_and_drive();
    run(2);
  }
  void flow(std::int32_t ma) { inputs.current_ma[0] = static_cast<std::int16_t>(ma); }
  /// Milliseconds until `fault` latches; 0: not within 300.
  int latched_after_ms(Fault fault) {
    for (int ms = 1; ms <= 300; ++ms) {
      run(1);
      if (latched_by(fault)) return ms;
    }
    return 0;
  }
};

TEST(BoardCoreBoundary, HalfAnAmpereMoreThanTheDutyDrivesMayFlow) {
  FullDuty bench;
  bench.flow(kDrivenMa + 500);
  EXPECT_EQ(bench.latched_after_ms(kUnexpectedCurrent), 0);
  bench.flow(-kDrivenMa - 501);
  EXPECT_EQ(bench.latched_after_ms(kUnexpectedCurrent), 5);
}

TEST(BoardCoreBoundary, AfterADriveTheAllowedCurrentFallsByAFifthPerMillisecond) {
  for (int followed_ms = 0; followed_ms < 60; ++followed_ms) {
    FullDuty bench;
    bench.set_point.duty_q15[0] = 0;
    bench.run(1);  // the duty of this millisecond applies in the next
    std::int32_t drivable_ma = kDrivenMa;
    const auto flow_above = [&](std::int32_t more_ma) {
      drivable_ma -= (drivable_ma + 4) / 5;
      bench.flow(drivable_ma + more_ma);
      bench.run(1);
    };
    for (int ms = 0; ms < followed_ms; ++ms) flow_above(500);
    for (int ms = 0; ms < 4; ++ms) flow_above(501);
    ASSERT_TRUE(bench.drives()) << followed_ms;
    flow_above(501);
    EXPECT_TRUE(bench.latched_by(kUnexpectedCurrent)) << followed_ms;
  }
}

TEST(BoardCoreBoundary, ADutyThatRisesMayDriveAtOnce) {
  FullDuty bench;
  bench.set_point.duty_q15[0] = 0;
  bench.run(100);
  bench.set_point.duty_q15[0] = INT16_MAX;
  bench.run(1);
  bench.flow(kDrivenMa + 500);
  EXPECT_EQ(bench.latched_after_ms(kUnexpectedCurrent), 0);
}

TEST(BoardCoreBoundary, TheSupplyMayExceedTheWindingsByAnEighthAndAnAmpereAndAHalf) {
  FullDuty bench;
  bench.inputs.supply_current_measured = true;
  bench.flow(8000);
  bench.inputs.supply_ma = 8000 + 1000 + 1500;
  EXPECT_EQ(bench.latched_after_ms(kUnexpectedCurrent), 0);
  bench.flow(1);
  bench.inputs.supply_ma = 1501;
  EXPECT_EQ(bench.latched_after_ms(kUnexpectedCurrent), 0);
  bench.flow(8000);
  bench.inputs.supply_ma = 10'501;
  EXPECT_EQ(bench.latched_after_ms(kUnexpectedCurrent), 20);
}

TEST(BoardCoreBoundary, RegeneratedCurrentIsNoCreditForTheSupply) {
  FullDuty bench;
  bench.inputs.supply_current_measured = true;
  bench.flow(-8000);
  bench.inputs.supply_ma = 1500;
  EXPECT_EQ(bench.latched_after_ms(kUnexpectedCurrent), 0);
  bench.inputs.supply_ma = 1501;
  EXPECT_EQ(bench.latched_after_ms(kUnexpectedCurrent), 20);
}

TEST(BoardCoreBoundary, AnUnmeasuredSupplyCurrentIsNotChecked) {
  FullDuty bench;
  bench.inputs.supply_ma = 60'000;
  EXPECT_EQ(bench.latched_after_ms(kUnexpectedCurrent), 0);
  bench.set_point.enable = false;
  EXPECT_EQ(bench.latched_after_ms(kStuckBridge), 0);
}

TEST(BoardCoreBoundary, ASleepingBallMayDrawHundredAndFiftyMilliamperes) {
  FullDuty bench;
  bench.inputs.supply_current_measured = true;
  bench.set_point.enable = false;
  bench.run(1);
  bench.inputs.supply_ma = 150;
  EXPECT_EQ(bench.latched_after_ms(kStuckBridge), 0);
  bench.inputs.supply_ma = 151;
  EXPECT_EQ(bench.latched_after_ms(kStuckBridge), 20);
  EXPECT_FALSE(bench.outputs.supply_switch_closed);
  EXPECT_FALSE(bench.telemetry().supply_switch_closed);
}

// The capacitors behind the switch charge through the supply line (firmware/board/bring-up.md, 5).
TEST(BoardCoreBoundary, TheSupplyLineCountsTwoHundredMillisecondsAfterTheSwitchHasClosed) {
  BoardLimits limits;
  limits.supply_settled_ms = 20;
  CoreBench bench(limits);
  bench.inputs.supply_current_measured = true;
  const auto close_switch = [&bench] {
    bench.inputs.supply_mv = 12'000;
    while (!bench.outputs.supply_switch_closed) bench.run(1);
  };
  bench.run(1);
  close_switch();
  bench.inputs.supply_ma = 500;
  bench.run(kChargingMs);
  bench.inputs.supply_ma = 0;
  bench.run(1);
  EXPECT_EQ(bench.core.faults() & kStuckBridge, 0);
  bench.inputs.supply_mv = 31'000;
  bench.run(kSupplyMs);
  ASSERT_FALSE(bench.outputs.supply_switch_closed);
  close_switch();
  bench.inputs.supply_ma = 500;
  bench.run(kChargingMs + kStuckMs - 2);
  EXPECT_EQ(bench.core.faults() & kStuckBridge, 0);
  bench.run(1);
  EXPECT_NE(bench.core.faults() & kStuckBridge, 0);
  EXPECT_FALSE(bench.outputs.supply_switch_closed);
}

TEST(BoardCoreBoundary, TheWindingsOwnAmplifiersCountWhileTheCapacitorsCharge) {
  CoreBench bench;
  bench.inputs.current_ma[1] = 501;
  bench.run(1 + kStuckMs);
  EXPECT_NE(bench.core.faults() & kStuckBridge, 0);
  EXPECT_FALSE(bench.outputs.supply_switch_closed);
}

TEST(BoardCoreBoundary, AnUnmeasuredCurrentIsThreeQuartersOfTheLast) {
  BoardLimits limits = no_other_limits();
  limits.current_ma = 12'000;
  for (const std::int32_t measured_ma : {16'000, 16'004}) {
    FullDuty bench(limits);
    bench.flow(measured_ma);
    bench.run(49);
    bench.inputs.currents_measured = 6;
    bench.run(1);
    EXPECT_EQ(bench.latched_by(kOverCurrent), measured_ma == 16'004) << measured_ma;
  }
}

TEST(BoardCoreBoundary, TheFirstMillisecondAfterPowerUpCountsAsOne) {
  CoreBench bench;
  bench.inputs.bridge_faults = 4;
  bench.run(2);
  EXPECT_EQ(bench.core.faults(), 0);
  bench.run(1);
  EXPECT_TRUE(bench.has(kBridge));
}

// -- I^2 t ---------------------------------------------------------------------------------------

TEST(BoardCoreBoundary, TheBudgetOfAWindingIsItsOwn) {
  BoardLimits limits = no_other_limits();
  limits.winding_a2s = 10;  // 100 A^2 s in a second, minus the leak
  FullDuty bench(limits);
  bench.flow(10'000);
  EXPECT_EQ(bench.latched_after_ms(kHeatBudget), 101);
  EXPECT_EQ(bench.telemetry().winding_heat_permille, 1009);
  EXPECT_EQ(bench.telemetry().device_heat_permille, 0);
}

TEST(BoardCoreBoundary, TheBudgetOfTheDeviceIsTheSumOfTheThree) {
  BoardLimits limits = no_other_limits();
  limits.device_a2s = 10;
  FullDuty bench(limits);
  for (int k = 0; k < kWindings; ++k) {
    bench.set_point.duty_q15[k] = INT16_MAX;
    bench.inputs.current_ma[k] = 5000;
  }
  EXPECT_EQ(bench.latched_after_ms(kHeatBudget), 134);
  EXPECT_EQ(bench.telemetry().winding_heat_permille, 0);
  EXPECT_EQ(bench.telemetry().device_heat_permille, 1004);
}

TEST(BoardCoreBoundary, BothBudgetsTightenByTheShareOfTheBuiltInOnes) {
  CoreBench bench;
  const BoardLimits built;
  bench.send(LimitsFrame{0, INT16_MAX, UINT16_MAX, 1001});
  bench.run(1);
  EXPECT_EQ(bench.core.limits().winding_a2s, built.winding_a2s);
  EXPECT_EQ(bench.core.limits().device_a2s, built.device_a2s);
  bench.send(LimitsFrame{0, 7499, 16'499, 250});
  bench.run(1);
  EXPECT_EQ(bench.core.limits().sensor_cc, 7499);
  EXPECT_EQ(bench.core.limits().current_ma, 16'499);
  EXPECT_EQ(bench.core.limits().winding_a2s, built.winding_a2s / 4);
  EXPECT_EQ(bench.core.limits().device_a2s, built.device_a2s / 4);
}

// -- a driven current that is not measured
// -----------------------------------------------------------

struct Blind : FullDuty {
  explicit Blind(std::int16_t duty_q15) {
    inputs.currents_measured = 6;
    set_point.duty_q15[0] = 0;
    run(1);
    set_point.duty_q15[0] = duty_q15;
    run(1);  // the duty of this millisecond applies in the next
  }
};

TEST(BoardCoreBoundary, UnmeasuredForTwentyFiveMillisecondsIsABrokenSensorInBothDirections) {
  EXPECT_EQ(Blind(2622).latched_after_ms(kCurrentSense), 25);
  EXPECT_EQ(Blind(-2622).latched_after_ms(kCurrentSense), 26) << "the first is a turn";
  EXPECT_EQ(Blind(2621).latched_after_ms(kCurrentSense), 0) << "two amperes may show nothing";
}

TEST(BoardCoreBoundary, AReversalRestartsTheUnmeasuredTime) {
  for (const int way : {1, -1}) {
    const auto duty = static_cast<std::int16_t>(8000 * way);
    Blind bench(duty);
    bench.run(22);
    bench.set_point.duty_q15[0] = static_cast<std::int16_t>(-duty);
    bench.run(1);
    EXPECT_TRUE(bench.drives());
    EXPECT_EQ(bench.latched_after_ms(kCurrentSense), 26) << duty;
  }
}

TEST(BoardCoreBoundary, OneMeasurementRestartsTheUnmeasuredTime) {
  Blind bench(8000);
  bench.run(24);
  bench.inputs.currents_measured = 7;
  bench.run(1);
  bench.inputs.currents_measured = 6;
  EXPECT_EQ(bench.latched_after_ms(kCurrentSense), 25);
}

}  // namespace
}  // namespace hedgehog::board
