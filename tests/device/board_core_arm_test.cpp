// SPDX-License-Identifier: MIT
// Arming requires an explicit request; nothing else makes a board drive.
#include <gtest/gtest.h>

#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

TEST(Arming, SetPointsAloneNeverDriveAfterPowerUp) {
  CoreBench bench;
  bench.run(5000);
  EXPECT_EQ(bench.core.mode(), Mode::kSafe);
  EXPECT_FALSE(bench.drives());
}

TEST(Arming, AnArmFrameMakesItReadyAndTheNextSetPointDrives) {
  CoreBench bench;
  bench.feed();
  bench.request_arm();
  bench.step();
  EXPECT_EQ(bench.core.mode(), Mode::kReady);
  EXPECT_FALSE(bench.drives()) << "a set-point from before the arming must not drive";
  bench.run(1);
  EXPECT_EQ(bench.core.mode(), Mode::kDriving);
  EXPECT_TRUE(bench.outputs.awake);
  EXPECT_EQ(bench.outputs.duty_q15[0], 8000);
  EXPECT_EQ(bench.telemetry().arm_count, 1);
}

TEST(Arming, IsRefusedWithoutSetPoints) {
  CoreBench bench;
  bench.feeding = false;
  bench.request_arm();
  bench.run(1);
  EXPECT_EQ(bench.core.mode(), Mode::kSafe);
  bench.feed();
  bench.run(100);
  bench.request_arm();
  bench.run(1);
  EXPECT_EQ(bench.core.mode(), Mode::kSafe);
}

TEST(Arming, TheSameCountArmsOnlyOnce) {
  CoreBench bench;
  bench.arm_and_drive();
  bench.feeding = false;
  bench.run(100);
  ASSERT_TRUE(bench.latched_by(kDeadMan));
  bench.feeding = true;
  ArmFrame repeated;
  repeated.count = bench.arm_count;
  bench.feed();
  bench.send(repeated);
  bench.run(10);
  EXPECT_TRUE(bench.latched_by(kDeadMan));
  bench.arm_and_drive();
  EXPECT_TRUE(bench.drives());
}

TEST(Arming, IsRefusedWhileTheFaultPersists) {
  CoreBench bench;
  bench.arm_and_drive();
  bench.inputs.thermistor[0].open = true;
  bench.run(kSensorBrokenMs);
  ASSERT_TRUE(bench.latched_by(kSensorOpen));
  bench.feed();
  bench.request_arm();
  bench.step();
  EXPECT_TRUE(bench.latched_by(kSensorOpen)) << "not armed for a single millisecond";
  EXPECT_EQ(bench.telemetry().arm_count, bench.arm_count) << "refused, but answered";
  bench.inputs.thermistor[0].open = false;
  bench.run(10);
  EXPECT_TRUE(bench.latched_by(kSensorOpen)) << "a fault that is gone stays latched";
  bench.arm_and_drive();
  EXPECT_TRUE(bench.drives());
  EXPECT_EQ(bench.core.faults(), 0);
}

TEST(Arming, EnableIsSeparateFromTheSetPoint) {
  CoreBench bench;
  bench.arm_and_drive();
  bench.set_point.enable = false;
  bench.run(1);
  EXPECT_FALSE(bench.outputs.awake);
  EXPECT_EQ(bench.outputs.duty_q15[0], 0);
  bench.set_point.enable = true;
  bench.set_point.duty_q15[0] = 0;
  bench.run(1);
  EXPECT_TRUE(bench.outputs.awake) << "enabled with duty 0 is a brake, not sleep";
}

TEST(Arming, TheLowestDutyIsAsFarAsTheHighest) {
  CoreBench bench;
  bench.set_point.duty_q15[1] = INT16_MIN;
  bench.arm_and_drive();
  EXPECT_EQ(bench.outputs.duty_q15[1], -INT16_MAX);
}

TEST(Telemetry, ReportsTheLastAndTheNextStateOfTheBridges) {
  CoreBench bench;
  bench.arm_and_drive();
  TelemetryFrame telemetry = bench.telemetry();
  EXPECT_EQ(telemetry.duty_q15[0], 0) << "they slept until now";
  EXPECT_TRUE(telemetry.bridges_awake);
  bench.inputs.current_ma[0] = 1234;
  bench.run(1);
  const std::uint32_t last = telemetry.sequence;
  telemetry = bench.telemetry();
  EXPECT_EQ(telemetry.sequence, last + 1);
  EXPECT_EQ(telemetry.duty_q15[0], 8000);
  EXPECT_EQ(telemetry.current_ma[0], 1234);
  EXPECT_EQ(telemetry.board_ms, bench.core.now_ms());
  EXPECT_EQ(telemetry.set_point_sequence, bench.sequence);
  EXPECT_EQ(telemetry.set_point_age_ms, 0);
}

}  // namespace
}  // namespace hedgehog::board
