// SPDX-License-Identifier: MIT
// A fault that trips only an armed ball masks none that trips every ball, and a board that latched
// for heat is not armed before it has cooled down.
#include <cmath>

#include "daemon/device/simulator/simulator_settings.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

TEST(MaskedReasons, ABridgeFaultDoesNotHideHeatWhileDisarmed) {
  rig::RigOptions options;
  options.control.arm_at_start = false;
  options.board.start_c = 72.0;
  rig::Rig rig(options);
  rig.set_faults(device::kSimBridgeFault);
  rig.run(200);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
  EXPECT_EQ(name(rig.controller().reason()), "overheated");
}

TEST(MaskedReasons, ABoardLatchedForHeatIsNotArmedAtStartBeforeItIsCool) {
  device::SimulatedBoardOptions warm;
  warm.start_c = 77.0;
  device::SimulatedBoard board(warm);
  for (int i = 0; i < 600'000 && (i < 1000 || board.plant().sensor_c() > 66.0); ++i) board.step();
  ASSERT_EQ(board.core().mode(), board::Mode::kLatched);
  ASSERT_LT(board.plant().sensor_c(), 67.0);
  rig::Rig rig;
  rig.board() = board;
  rig.run(500);
  EXPECT_EQ(name(rig.controller().state()), "disarmed");
  EXPECT_EQ(name(rig.snapshot().arming_blocker), "board_over_heat");
  ASSERT_TRUE(
      rig.run_until([&] { return rig.controller().state() == control::State::kArmed; }, 3'000'000));
  EXPECT_LT(rig.plant().sensor_c(), 60.0);
}

TEST(Asleep, WhileAnEffectOnlyWaitsForItsOnset) {
  rig::Rig rig;
  rig.run_until_armed();
  model::EffectSpec spec = rig::pulse({1, 0, 0}, 5.0, 100);
  spec.delay = 200;
  rig.start(spec);
  for (int i = 0; i < 190; ++i) {
    rig.tick();
    ASSERT_FALSE(rig.last_command().enable()) << i;
    ASSERT_TRUE(asleep(rig)) << i;
  }
  rig.run(60);
  EXPECT_NEAR(rig.current_a(), 5.0, 0.1);
}

TEST(Asleep, NotBetweenThePeriodsOfAVibration) {
  rig::Rig rig;
  rig.run_until_armed();
  model::EffectSpec spec = rig::hold({1, 0, 0}, 5.0);
  spec.method = model::EffectMethod::kVibrate;
  spec.waveform = model::Waveform::kSquare;
  spec.frequency_hz = 10.0;
  rig.start(spec);
  rig.tick();
  for (int i = 0; i < 500; ++i) {
    rig.tick();
    ASSERT_TRUE(rig.last_command().enable()) << i;
  }
}

TEST(Unknown, NothingIsAllowedBeforeTheFirstReading) {
  rig::RigOptions options;
  options.control.arm_at_start = false;
  rig::Rig rig(options);
  rig.set_faults(device::kSimSensorOpen);
  rig.tick();
  EXPECT_TRUE(std::isinf(rig.snapshot().thermal.hottest_c));
  EXPECT_EQ(rig.snapshot().limit_a, 0.0);
  rig.set_faults(0);
  rig.run(500);
  EXPECT_TRUE(std::isfinite(rig.snapshot().thermal.hottest_c));
  EXPECT_EQ(rig.snapshot().limit_a, 15.0);
}

}  // namespace
}  // namespace hedgehog::safety
