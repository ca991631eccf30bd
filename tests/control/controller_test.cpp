// SPDX-License-Identifier: MIT
// The whole controller: arming, effects, reports, no allocations.
#include <gtest/gtest.h>

#include "daemon/device/simulator/simulator_settings.h"
#include "tests/rig/rig.h"

namespace hedgehog::control {
namespace {

TEST(Arming, TheSimulatorIsArmedWithinMillisecondsOfItsDetection) {
  rig::Rig rig;
  rig.run(10);
  EXPECT_EQ(name(rig.controller().state()), "armed");
  EXPECT_EQ(rig.board().core().mode(), board::Mode::kReady);
  EXPECT_FALSE(rig.last_command().enable()) << "armed and asked nothing: the bridges sleep";
}

TEST(Arming, NeverArmsByItselfIfConfiguredSo) {
  rig::RigOptions options;
  options.control.arm_at_start = false;
  rig::Rig rig(options);
  const auto effect = rig.start(rig::hold({1, 0, 0}, 5.0));
  rig.run(500);
  EXPECT_EQ(name(rig.controller().state()), "disarmed");
  EXPECT_EQ(name(rig.controller().reason()), "never_armed");
  EXPECT_FALSE(rig.playing(effect));
  EXPECT_EQ(rig.board().core().mode(), board::Mode::kSafe) << "set-points never arm";
  rig.arm();
  rig.run(10);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

TEST(Arming, ReportsItsBlockerAndWaitsForAPlausibleSensor) {
  rig::RigOptions options;
  options.control.arm_at_start = false;
  rig::Rig rig(options);
  rig.set_faults(device::kSimSensorOpen);
  rig.run(100);
  EXPECT_EQ(name(rig.controller().state()), "disarmed")
      << "a broken sensor trips an armed ball only";
  EXPECT_EQ(name(rig.snapshot().arming_blocker), "sensor_open");
  EXPECT_FALSE(rig.snapshot().sensor_valid);
  rig.arm();
  rig.run(400);
  EXPECT_EQ(name(rig.controller().state()), "disarmed");
  rig.set_faults(0);
  rig.run(100);
  EXPECT_EQ(name(rig.snapshot().arming_blocker), "none");
  rig.arm();
  rig.run(20);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

TEST(Arming, ABoardThatRestartsIsDisarmed) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 5.0));
  rig.run(50);
  rig.board() = device::SimulatedBoard();
  rig.run(200);
  EXPECT_EQ(name(rig.controller().state()), "disarmed");
  EXPECT_EQ(name(rig.controller().reason()), "hot_plug");
  EXPECT_EQ(rig.current_a(), 0.0);
}

TEST(Currents, FollowTheCoilMatrixAndTheStrengthExactly) {
  rig::RigOptions options;
  options.control.coils.matrix = {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};
  rig::Rig rig(options);
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 6.0));
  rig.run(300);
  EXPECT_NEAR(rig.plant().current_a().y, -6.0, 0.01);
  EXPECT_NEAR(rig.plant().current_a().x, 0.0, 0.01);
  EXPECT_NEAR(rig.snapshot().demand_a.x, 6.0, 1e-9);
}

TEST(Currents, RawCoilAxesSkipTheMatrix) {
  rig::RigOptions options;
  options.control.coils.matrix = {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};
  rig::Rig rig(options);
  rig.run_until_armed();
  model::EffectSpec spec = rig::hold({1, 0, 0}, 3.0);
  spec.frame = model::Frame::kCoil;
  rig.start(spec);
  rig.run(300);
  EXPECT_NEAR(rig.plant().current_a().x, 3.0, 0.01);
  EXPECT_NEAR(rig.snapshot().demand_a.y, 3.0, 1e-9);
}

TEST(Currents, ASleepingBridgeFollowsTheLastEffect) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::pulse({0, 0, 1}, 15.0, 150));
  rig.run(151);
  EXPECT_FALSE(rig.last_command().enable());
  rig.run(17);
  EXPECT_EQ(rig.current_a(), 0.0);
}

TEST(Commands, AppliedSequenceGainAndLimits) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.command(SetGain{0.5});
  rig.start(rig::hold({1, 0, 0}, 8.0));
  rig.run(300);
  EXPECT_EQ(rig.snapshot().applied_seq, 2u);
  EXPECT_EQ(rig.snapshot().gain, 0.5);
  EXPECT_NEAR(rig.current_a(), 4.0, 0.02);
  rig.command(SetGain{1.5});
  rig.command(SetGain{-1.0});
  model::Limits limits;
  limits.current_a = 3.0;
  limits.continuous_a = 3.0;
  rig.command(SetLimits{limits});
  rig.run(300);
  EXPECT_EQ(rig.snapshot().gain, 0.5);
  EXPECT_NEAR(rig.current_a(), 3.0, 0.02);
  for (const double gain : {0.0, 1.0, 0.5}) {
    rig.command(SetGain{gain});
    rig.run(1);
    EXPECT_EQ(rig.snapshot().gain, gain);
  }
  limits.trip_c = 90.0;  // beyond the device file
  limits.current_a = 10.0;
  rig.command(SetLimits{limits});
  rig.run(50);
  EXPECT_NEAR(rig.current_a(), 3.0, 0.02);
}

TEST(Derating, IsReportedWhenItBeginsAndWhenItEnds) {
  rig::RigOptions options;
  options.board.start_c = 58.0;
  rig::Rig rig(options);
  rig.run_until_armed();
  const auto effect = rig.start(rig::hold({1, 0, 0}, 15.0));
  ASSERT_TRUE(rig.run_until([&] { return rig.snapshot().derating; }, 10'000));
  EXPECT_EQ(rig.count(EventType::kDeratingStarted), 1);
  EXPECT_GT(rig.last(EventType::kDeratingStarted)->temperature_c, 59.9);
  rig.run(3000);
  EXPECT_EQ(rig.count(EventType::kDeratingStarted), 1);
  rig.stop(effect);
  rig.run(600);
  EXPECT_EQ(rig.count(EventType::kDeratingEnded), 1);
  const Event* end = rig.last(EventType::kEffectEnded);
  ASSERT_NE(end, nullptr);
  EXPECT_LT(end->delivery.min, 0.99);
}

TEST(Derating, EndsHalfASecondAfterTheLastReduction) {
  Derating derating;
  derating.step(10.0, 9.96, 900);
  EXPECT_FALSE(derating.active()) << "too little to be noticed";
  derating.step(10.0, 9.9, 1000);
  derating.step(10.0, 10.0, 1500);
  EXPECT_TRUE(derating.active());
  derating.step(10.0, 10.0, 1501);
  EXPECT_FALSE(derating.active());
  derating.step(0.5, 0.2, 3000);
  EXPECT_TRUE(derating.active());
}

TEST(Derating, AStrengthBeyondTheConfiguredLimitIsNoDerating) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 15.0));
  rig.start(rig::hold({0, 1, 0}, 15.0));  // together 21 A: mixing limits them, not heat
  rig.run(2000);
  EXPECT_FALSE(rig.snapshot().derating);
  EXPECT_EQ(rig.count(EventType::kDeratingStarted), 0);
}

TEST(Circle, TenPinsASecondAreTenStepsASecond) {
  rig::Rig rig;
  rig.run_until_armed();
  model::EffectSpec spec;
  spec.method = model::EffectMethod::kCircle;
  spec.trajectory.path = model::Path::kCircle;
  spec.trajectory.speed_pins_s = 10.0;
  spec.duration = 10'000;
  rig.start(spec);
  rig.tick();
  model::Vec3 last = rig.snapshot().demand_a;
  EXPECT_NEAR(last.x, 5.0, 1e-9) << "the first step is at the front";
  int steps = 0;
  model::Tick last_step = rig.now();
  for (int i = 0; i < 9999; ++i) {
    rig.tick();
    const model::Vec3 now = rig.snapshot().demand_a;
    if (norm(now - last) > 0.1) {
      ++steps;
      EXPECT_NEAR(static_cast<double>(rig.now() - last_step), 100.0, 1.0);
      EXPECT_NEAR(std::acos(dot(now, last) / 25.0) * 57.29578, 24.0, 0.01) << "15 steps a turn";
      last_step = rig.now();
    }
    last = now;
  }
  EXPECT_EQ(steps, 99) << "100 positions in 10 s";
}

TEST(Heading, RecentreTurnsWorldEffects) {
  rig::Rig rig;
  const model::Quaternion left = model::axis_angle({0, 0, 1}, 90.0);
  rig.orient(left);
  rig.run_until_armed();
  model::EffectSpec spec = rig::hold({1, 0, 0}, 5.0);
  spec.frame = model::Frame::kWorld;
  rig.start(spec);
  rig.run(300);
  EXPECT_NEAR(rig.plant().current_a().y, -5.0, 0.05) << "world x is to the right of the front";
  rig.command(Recenter{0.0});
  rig.run(100);
  EXPECT_NEAR(rig.plant().current_a().x, 5.0, 0.05);
  rig.command(Recenter{90.0});
  rig.run(100);
  EXPECT_NEAR(rig.plant().current_a().y, -5.0, 0.05);
  EXPECT_NEAR(rig.snapshot().yaw_offset_deg, 0.0, 1e-9);
}

// A driver's own sensor measures no current while its bridge brakes.
TEST(FanByCurrent, UsesTheExpectedCurrentWhereNoneIsMeasured) {
  ControlSettings settings = rig::RigOptions::armed_at_start();
  Controller controller(settings);
  StepInputs inputs;
  EventList events;
  inputs.board_present = inputs.board_fresh = true;
  inputs.board.mode = device::BoardMode::kReady;
  inputs.board.supply_v = 12.0;
  inputs.board.measured = {false, false, false};
  inputs.board.sensor_c = 25.0;
  device::BoardCommand command;
  int ticks = 0;
  for (; ticks < 40'000 && command.fan == 0; ++ticks) {
    ++inputs.tick;
    ++inputs.board.sequence;
    inputs.board.sensor_conversions = static_cast<std::uint8_t>(ticks / 10);
    inputs.board.arm_count = command.arm_count;
    inputs.board.bridges_awake = command.enable();
    inputs.board.mode = command.enable() ? device::BoardMode::kDriving : device::BoardMode::kReady;
    inputs.board.duty = command.duty();
    inputs.command_count = controller.effects_empty() && controller.state() == State::kArmed;
    StartEffect start;
    start.effect = static_cast<EffectId>(ticks) + 1;
    start.spec = rig::pulse({1, 0, 0}, 5.0, 10'000);
    inputs.commands[0] = {static_cast<std::uint64_t>(ticks) + 1, start};
    command = controller.step(inputs, events);
  }
  ASSERT_EQ(name(controller.state()), "armed") << name(controller.reason());
  EXPECT_LT(controller.thermal().hottest_c, model::Fan::kOnAboveC) << "it is not by heat";
  EXPECT_NEAR(ticks * 1e-3, 30.0 * std::log(5.0 / 2.0), 1.0);
}

}  // namespace
}  // namespace hedgehog::control
