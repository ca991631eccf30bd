// SPDX-License-Identifier: MIT
// Transition of a board into its boot loader: never while current flows, never from an armed ball,
// and without a trip.
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::EnterBootLoader;
using control::EventType;
using device::SimulatedBoard;

struct BootLoader : testing::Test {
  rig::Rig rig;

  void SetUp() override { rig.run_until_armed(); }
  std::string state() const {
    return std::string(name(rig.controller().state())) + " " +
           std::string(name(rig.controller().reason()));
  }
};

TEST_F(BootLoader, ADisarmedBoardDisappearsWithoutATripAndReturnsDisarmed) {
  rig.emergency_stop();
  rig.run(100);
  rig.clear_events();
  rig.command(EnterBootLoader{});
  rig.run(200);
  EXPECT_EQ(state(), "absent boot_loader");
  EXPECT_EQ(name(rig.snapshot().last_trip.reason), "none");
  ASSERT_NE(rig.last(EventType::kStateChanged), nullptr);
  EXPECT_FALSE(rig.last(EventType::kStateChanged)->trip);
  rig.run(SimulatedBoard::kBootLoaderMs);
  EXPECT_EQ(state(), "disarmed emergency_stop") << "the latch is the daemon's";
  rig.arm();
  rig.run(100);
  EXPECT_EQ(state(), "armed none");
  rig.start(rig::hold({1, 0, 0}, 5.0));
  rig.run(100);
  EXPECT_NEAR(rig.current_a(), 5.0, 0.05);
}

TEST_F(BootLoader, AnArmedBallStaysAndContinuesPlaying) {
  rig.start(rig::hold({1, 0, 0}, 5.0));
  rig.run(100);
  rig.command(EnterBootLoader{});
  rig.run(300);
  EXPECT_EQ(state(), "armed none");
  EXPECT_NEAR(rig.current_a(), 5.0, 0.05);
}

TEST_F(BootLoader, AnArmedBallThatPlaysNothingStaysToo) {
  rig.run(100);
  ASSERT_FALSE(rig.last_command().enable());
  rig.command(EnterBootLoader{});
  rig.run(300);
  EXPECT_EQ(state(), "armed none");
}

TEST_F(BootLoader, OfAnArmingAndThisInOneTickTheFirstIsApplied) {
  for (const bool arm_first : {true, false}) {
    rig.emergency_stop();
    rig.run(100);
    if (arm_first) rig.arm();
    rig.command(EnterBootLoader{});
    if (!arm_first) rig.arm();
    rig.run(200);
    EXPECT_EQ(state(), arm_first ? "armed none" : "absent boot_loader");
  }
  EXPECT_EQ(name(rig.snapshot().last_trip.reason), "none");
}

TEST_F(BootLoader, RightAfterAnEmergencyStopItWaitsUntilNothingFlows) {
  rig.start(rig::hold({1, 1, 1}, 15.0));
  rig.run(300);
  rig.emergency_stop();
  rig.tick();
  ASSERT_GT(rig.current_a(), kZeroA);
  rig.command(EnterBootLoader{});
  while (rig.current_a() >= kZeroA) {
    ASSERT_TRUE(rig.board().core().outputs().supply_switch_closed);
    ASSERT_FALSE(rig.board().core().boot_loader_due());
    rig.tick();
  }
  rig.run(200);
  EXPECT_EQ(state(), "absent boot_loader");
  EXPECT_LT(rig.current_a(), kZeroA);
}

}  // namespace
}  // namespace hedgehog::safety
