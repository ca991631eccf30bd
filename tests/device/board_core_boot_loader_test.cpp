// SPDX-License-Identifier: MIT
// A board enters its boot loader only on a request that arrives while its bridges are asleep.
#include <gtest/gtest.h>

#include <array>

#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

TEST(BootLoader, IsEnteredByABoardThatWasNeverArmed) {
  CoreBench bench;
  bench.run(kBootLoaderMs);
  EXPECT_FALSE(bench.core.boot_loader_due());
  bench.send(BootLoaderFrame{});
  bench.run(1);
  EXPECT_TRUE(bench.core.boot_loader_due());
  EXPECT_FALSE(bench.drives());
}

TEST(BootLoader, IsEnteredByALatchedBoardAndWithoutSetPoints) {
  CoreBench bench;
  bench.arm_and_drive();
  bench.feeding = false;
  bench.run(100 + kBootLoaderMs);
  ASSERT_TRUE(bench.latched_by(kDeadMan));
  bench.send(BootLoaderFrame{});
  bench.run(1);
  EXPECT_TRUE(bench.core.boot_loader_due());
  EXPECT_FALSE(bench.drives());
}

TEST(BootLoader, IsRefusedByADrivingBoardWhichContinues) {
  CoreBench bench;
  bench.arm_and_drive();
  bench.run(100);
  const auto refused = bench.telemetry().refused;
  bench.send(BootLoaderFrame{});
  bench.run(1);
  EXPECT_FALSE(bench.core.boot_loader_due());
  EXPECT_TRUE(bench.drives());
  EXPECT_EQ(bench.telemetry().refused, refused + 1);
  // The request is not stored.
  bench.feeding = false;
  bench.run(200);
  ASSERT_TRUE(bench.latched_by(kDeadMan));
  EXPECT_FALSE(bench.core.boot_loader_due());
}

// There is no frame for disarming: a host that has disarmed puts the bridges to sleep.
TEST(BootLoader, IsEnteredByAReadyBoardAfterItsBridgesHaveSlept) {
  CoreBench bench;
  bench.arm_and_drive();
  bench.set_point.enable = false;
  for (std::uint32_t ms = 1; ms < kBootLoaderMs; ++ms) {
    bench.send(BootLoaderFrame{});
    bench.run(1);
    ASSERT_EQ(bench.core.mode(), Mode::kReady);
    ASSERT_FALSE(bench.core.boot_loader_due()) << ms;
  }
  bench.send(BootLoaderFrame{});
  bench.run(1);
  EXPECT_TRUE(bench.core.boot_loader_due());
  EXPECT_FALSE(bench.drives());
}

TEST(BootLoader, IsNotEnteredInAMillisecondThatDrives) {
  CoreBench bench;
  bench.set_point.enable = false;
  bench.arm_and_drive();
  bench.run(kBootLoaderMs);
  bench.set_point.enable = true;
  bench.send(BootLoaderFrame{});
  bench.run(1);
  EXPECT_TRUE(bench.drives());
  EXPECT_FALSE(bench.core.boot_loader_due());
}

TEST(BootLoader, RequiresItsKey) {
  CoreBench bench;
  std::array<std::uint8_t, kFrameSize> frame;
  BootLoaderFrame request;
  request.sequence = 1;
  request.key = 0;
  write_frame(request, frame.data());
  bench.feeding = false;
  bench.run(kBootLoaderMs);
  bench.core.receive(frame.data(), frame.size());
  bench.run(1);
  EXPECT_FALSE(bench.core.boot_loader_due());
  EXPECT_EQ(bench.telemetry().refused, 1);
}

TEST(BootLoader, IsDueInOneMillisecondOnly) {
  CoreBench bench;
  bench.run(kBootLoaderMs);
  bench.send(BootLoaderFrame{});
  bench.run(1);
  ASSERT_TRUE(bench.core.boot_loader_due());
  bench.run(1);
  EXPECT_FALSE(bench.core.boot_loader_due());
}

}  // namespace
}  // namespace hedgehog::board
