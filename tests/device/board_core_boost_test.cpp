// SPDX-License-Identifier: MIT
// The boost of a set-point applies in the millisecond in which it arrived only.
#include <gtest/gtest.h>

#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

struct Boost : testing::Test {
  CoreBench bench;

  void SetUp() override {
    bench.arm_and_drive();
    bench.feeding = false;
    bench.set_point.duty_q15[0] = 8000;
    bench.set_point.duty_q15[1] = -8000;
    bench.set_point.boost_q15[0] = 5000;
    bench.set_point.boost_q15[1] = -4000;
  }
  void expect_held() {
    EXPECT_EQ(bench.outputs.duty_q15[0], 8000);
    EXPECT_EQ(bench.outputs.duty_q15[1], -8000);
  }
  void expect_boosted() {
    EXPECT_EQ(bench.outputs.duty_q15[0], 13000);
    EXPECT_EQ(bench.outputs.duty_q15[1], -12000);
  }
};

TEST_F(Boost, LastsOneMillisecond) {
  bench.feed();
  bench.step();
  expect_boosted();
  for (int ms = 2; ms < 100; ++ms) {
    bench.step();
    expect_held();
  }
  bench.feed();
  bench.step();
  expect_boosted();
  bench.step();
  expect_held();
}

TEST_F(Boost, TelemetryReportsTheAppliedDuty) {
  bench.feed();
  bench.step();
  bench.step();
  EXPECT_EQ(bench.telemetry().duty_q15[0], 13000);
  bench.step();
  EXPECT_EQ(bench.telemetry().duty_q15[0], 8000);
}

TEST_F(Boost, IsNotRepeatedByRepeatedOrLateFrames) {
  bench.feed();
  bench.step();
  for (const std::uint32_t behind : {0u, 1u, 2u, 1000u}) {
    SetPointFrame again = bench.set_point;
    again.sequence = bench.sequence - behind;
    std::array<std::uint8_t, kFrameSize> frame;
    write_frame(again, frame.data());
    bench.core.receive(frame.data(), frame.size());
    bench.step();
    expect_held();
  }
}

TEST_F(Boost, IsNotRepeatedByFramesOfOtherTypes) {
  bench.feed();
  bench.step();
  bench.send(LimitsFrame{0, 7000, 16000, 900});
  bench.step();
  expect_held();
}

TEST_F(Boost, TheLastOfTwoFramesInAMillisecondCounts) {
  bench.feed();
  bench.set_point.boost_q15[0] = 1000;
  bench.feed();
  bench.step();
  EXPECT_EQ(bench.outputs.duty_q15[0], 9000) << "boosts do not add up";
}

TEST_F(Boost, TheSumStaysWithinTheBridge) {
  bench.set_point.duty_q15[0] = 30000;
  bench.set_point.boost_q15[0] = 32767;
  bench.set_point.duty_q15[1] = -30000;
  bench.set_point.boost_q15[1] = INT16_MIN;
  bench.set_point.duty_q15[2] = 32767;
  bench.set_point.boost_q15[2] = -32767;
  bench.feed();
  bench.step();
  EXPECT_EQ(bench.outputs.duty_q15[0], 32767);
  EXPECT_EQ(bench.outputs.duty_q15[1], -32767);
  EXPECT_EQ(bench.outputs.duty_q15[2], 0);
}

TEST_F(Boost, HasNoEffectWithoutEnable) {
  bench.set_point.enable = false;
  bench.feed();
  bench.step();
  EXPECT_FALSE(bench.drives());
}

TEST_F(Boost, DoesNotOutliveALatch) {
  bench.inputs.bridge_faults = 1;
  bench.feeding = true;
  bench.run(kBridgeFaultMs);
  EXPECT_TRUE(bench.latched_by(kBridge));
  bench.inputs.bridge_faults = 0;
  bench.feed();
  bench.step();
  EXPECT_FALSE(bench.drives());
  // Armed together with a boosted set-point: neither that set-point nor its boost drives.
  bench.feed();
  bench.request_arm();
  bench.step();
  EXPECT_EQ(bench.core.mode(), Mode::kReady);
  EXPECT_FALSE(bench.drives());
  bench.step();
  EXPECT_FALSE(bench.drives());
  bench.feed();
  bench.step();
  expect_boosted();
}

}  // namespace
}  // namespace hedgehog::board
