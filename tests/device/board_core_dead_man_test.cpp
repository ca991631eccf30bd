// SPDX-License-Identifier: MIT
// Only valid set-points reset the dead-man; without one for 100 ms the board is safe and latched.
#include <gtest/gtest.h>

#include "daemon/device/board_core/crc32.h"
#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

struct DeadMan : testing::Test {
  CoreBench bench;
  void SetUp() override {
    bench.arm_and_drive();
    ASSERT_TRUE(bench.drives());
    bench.feeding = false;
  }
  // The set-point of `arm_and_drive` was accepted in the last step, so its age is 0 now.
};

TEST_F(DeadMan, NinetyNineMillisecondsOfSilenceAreTolerated) {
  bench.run(99);
  EXPECT_TRUE(bench.drives());
  EXPECT_EQ(bench.core.mode(), Mode::kDriving);
  EXPECT_EQ(bench.core.set_point_age_ms(), 99u);
}

TEST_F(DeadMan, InTheHundredthItIsSafeAndLatchedWithTheFanFull) {
  bench.run(100);
  EXPECT_TRUE(bench.latched_by(kDeadMan));
}

TEST_F(DeadMan, ASetPointInTimeRestartsTheCount) {
  bench.run(98);
  bench.feed();
  bench.run(1);
  bench.run(99);
  EXPECT_TRUE(bench.drives());
  bench.run(1);
  EXPECT_TRUE(bench.latched_by(kDeadMan));
}

TEST_F(DeadMan, SetPointsNeverClearTheLatch) {
  bench.run(100);
  bench.feeding = true;
  bench.run(10'000);
  EXPECT_TRUE(bench.latched_by(kDeadMan));
}

TEST_F(DeadMan, SafeSetPointsFeedItToo) {
  bench.feeding = true;
  bench.set_point.enable = false;
  bench.run(1000);
  EXPECT_EQ(bench.core.mode(), Mode::kReady);
  EXPECT_FALSE(bench.drives());
}

TEST_F(DeadMan, ArmedButIdleItLatchesAsWell) {
  bench.set_point.enable = false;
  bench.feed();
  bench.run(1);
  ASSERT_EQ(bench.core.mode(), Mode::kReady);
  bench.run(100);
  EXPECT_TRUE(bench.latched_by(kDeadMan));
}

TEST_F(DeadMan, ArmFramesDoNotFeed) {
  for (int ms = 0; ms < 100; ++ms) {
    bench.request_arm();
    bench.step();
  }
  EXPECT_TRUE(bench.latched_by(kDeadMan));
}

TEST_F(DeadMan, LimitsAndSimulatorFramesDoNotFeed) {
  for (int ms = 0; ms < 100; ++ms) {
    bench.send(LimitsFrame{0, 7500, 16500, 1000});
    bench.send(SimulatorFrame{});
    bench.send(SimulatorErrorFrame{});
    bench.step();
  }
  EXPECT_TRUE(bench.latched_by(kDeadMan));
}

TEST_F(DeadMan, ARepeatedFrameDoesNotFeed) {
  std::array<std::uint8_t, kFrameSize> frame;
  bench.set_point.sequence = bench.sequence;
  write_frame(bench.set_point, frame.data());
  for (int ms = 0; ms < 100; ++ms) {
    bench.core.receive(frame.data(), frame.size());
    bench.step();
  }
  EXPECT_TRUE(bench.latched_by(kDeadMan));
  EXPECT_EQ(bench.telemetry().refused, 100);
}

TEST_F(DeadMan, LateFramesDoNotFeed) {
  for (std::uint32_t ms = 0; ms < 100; ++ms) {
    std::array<std::uint8_t, kFrameSize> frame;
    bench.set_point.sequence = bench.sequence - 1 - ms;
    write_frame(bench.set_point, frame.data());
    bench.core.receive(frame.data(), frame.size());
    bench.step();
  }
  EXPECT_TRUE(bench.latched_by(kDeadMan));
}

TEST_F(DeadMan, FramesOfAnotherVersionTypeOrLengthOrWithABrokenCrcDoNotFeed) {
  for (int ms = 0; ms < 100; ++ms) {
    std::array<std::uint8_t, kFrameSize + 1> frame{};
    bench.set_point.sequence = ++bench.sequence;
    write_frame(bench.set_point, frame.data());
    std::size_t length = kFrameSize;
    const auto with_good_crc = [&](std::size_t at, std::uint8_t value) {
      frame[at] = value;
      const std::uint32_t crc = crc32(frame.data(), kFrameSize - 4);
      for (std::size_t i = 0; i < 4; ++i)
        frame[kFrameSize - 4 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    };
    switch (ms % 6) {
      case 0:
        length = kFrameSize + 1;
        break;
      case 1:
        length = kFrameSize - 1;
        break;
      case 2:
        frame[63] ^= 1;
        break;
      case 3:
        with_good_crc(0, kFrameMagic + 1);
        break;
      case 4:
        with_good_crc(1, kProtocolVersion + 1);
        break;
      case 5:
        with_good_crc(2, 0x04);
        break;
    }
    bench.core.receive(frame.data(), length);
    bench.step();
  }
  EXPECT_TRUE(bench.latched_by(kDeadMan));
}

TEST_F(DeadMan, TheSequenceMayWrapAround) {
  for (const std::uint32_t jump :
       {0x70000000u, 0xE0000000u, 0xFFFFFF00u}) {  // each by less than half the range
    bench.sequence = jump - 1;
    bench.feed();
    bench.run(1);
  }
  bench.feeding = true;
  bench.run(400);
  EXPECT_TRUE(bench.drives());
  EXPECT_LT(bench.sequence, 0x100u);
  EXPECT_EQ(bench.telemetry().set_point_sequence, bench.sequence);
}

TEST(DeadManAfterPowerUp, ABoardThatWasNeverArmedIsSafeButNotLatched) {
  CoreBench bench;
  bench.feeding = false;
  bench.run(1000);
  EXPECT_EQ(bench.core.mode(), Mode::kSafe);
  EXPECT_EQ(bench.core.faults(), 0);
  EXPECT_FALSE(bench.drives());
}

TEST(DeadManAfterPowerUp, TheFanRunsWithoutAHostWhenItIsWarmOrUnknown) {
  CoreBench bench;
  bench.feeding = false;
  bench.run(1);
  EXPECT_EQ(bench.outputs.fan, 0);
  bench.inputs.thermistor[0].cc = kFanFromCc;
  bench.run(1);
  EXPECT_EQ(bench.outputs.fan, 255);
  CoreBench blind;
  blind.feeding = false;
  blind.inputs.thermistors_converted = false;
  blind.run(1);
  EXPECT_EQ(blind.outputs.fan, 255);
}

}  // namespace
}  // namespace hedgehog::board
