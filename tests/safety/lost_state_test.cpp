// SPDX-License-Identifier: MIT
// Without a thermal state: the saved state is damaged, or belongs to another ball.
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::Reason;

/// A ball at `celsius` whose saved state is lost.
rig::RigOptions with_lost_state(double celsius, int thermistors) {
  rig::RigOptions options;
  options.control.start_known = false;
  options.control.start_measured = {};
  options.control.latch = Reason::kStateLost;
  options.board.start_c = celsius;
  options.board.front_end.thermistors = thermistors;
  return options;
}

class LostState : public ::testing::TestWithParam<int> {};

TEST_P(LostState, IsATripAndArmsWhenItIsCertainlyCool) {
  rig::Rig rig(with_lost_state(25.0, GetParam()));
  rig.run(50);
  EXPECT_EQ(name(rig.controller().state()), "tripped") << "arm_at_start does not clear it";
  EXPECT_EQ(name(rig.controller().reason()), "state_lost");
  rig.start(rig::hold({1, 0, 0}, 5.0));
  rig.run(50);
  EXPECT_EQ(rig.current_a(), 0.0);
  ASSERT_TRUE(
      rig.run_until([&] { return rig.snapshot().arming_blocker == Reason::kNone; }, 300'000));
  rig.arm();
  rig.run(50);
  EXPECT_EQ(name(rig.controller().state()), "armed");
  rig.start(rig::hold({0, 1, 0}, 15.0));
  rig.run(2);
  EXPECT_NEAR(norm(rig.snapshot().limited_a), 5.0, 1e-6) << "until it has measured itself";
}

TEST_P(LostState, IsNotArmedWhileAWindingMayBeHot) {
  rig::Rig rig(with_lost_state(60.0, GetParam()));
  rig.run(50);
  rig.arm();
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
  EXPECT_EQ(name(rig.snapshot().arming_blocker), "state_lost");
  ASSERT_TRUE(
      rig.run_until([&] { return rig.snapshot().arming_blocker == Reason::kNone; }, 1'800'000));
  EXPECT_LT(rig.plant().hottest_winding_c(), 45.0);
}

INSTANTIATE_TEST_SUITE_P(Thermistors, LostState, ::testing::Values(1, 3));

TEST(OtherBall, StopsWithUnknownTemperatures) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({0, 1, 0}, 15.0));
  rig.run(3000);
  ASSERT_GT(rig.current_a(), 14.0);
  ASSERT_TRUE(rig.snapshot().thermal.measured[1]);
  rig.command(control::ResetBall{});
  rig.run(2);
  expect_zero(rig, 3);
  expect_tripped(rig, Reason::kStateLost);
  EXPECT_EQ(rig.snapshot().thermal.measured, (std::array<bool, model::kCoils>{}));
}

TEST(OtherBall, ThatHasDisconnectedTripsWhenItReturns) {
  rig::Rig rig;
  hold_five_ampere(rig);
  rig.emergency_stop();
  rig.drop_telemetry(200);
  rig.run(150);
  ASSERT_EQ(name(rig.controller().state()), "absent");
  rig.command(control::ResetBall{});
  rig.run(200);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
  EXPECT_EQ(name(rig.controller().reason()), "state_lost");
  EXPECT_EQ(rig.current_a(), 0.0);
}

TEST(OtherBall, DoesNotLoosenATrip) {
  rig::RigOptions options;
  options.control.latch = Reason::kSensorFrozen;
  rig::Rig rig(options);
  rig.run(50);
  rig.command(control::ResetBall{});
  rig.run(50);
  EXPECT_EQ(name(rig.snapshot().latch), "sensor_frozen");
}

}  // namespace
}  // namespace hedgehog::safety
