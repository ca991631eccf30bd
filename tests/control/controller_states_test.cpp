// SPDX-License-Identifier: MIT
// The controller's states: why a ball is absent, what prevents arming, and the end of all effects.
#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "tests/control/controlled.h"
#include "tests/rig/rig.h"

namespace hedgehog::control {
namespace {

TEST(Absent, AnUnpluggedBallHasLostItsTelemetryIfItWasSilentBefore) {
  const auto reason = [](int silent_ticks) {
    Controlled ball{ControlSettings{}};
    ball.run(50);
    ball.inputs.board_fresh = false;
    ball.run(silent_ticks);
    EXPECT_NE(name(ball.controller.state()), "absent");
    ball.inputs.board_present = false;
    ball.step();
    EXPECT_EQ(name(ball.controller.state()), "absent");
    return name(ball.controller.reason());
  };
  EXPECT_EQ(reason(0), "no_board");
  EXPECT_EQ(reason(40), "no_board");
  EXPECT_EQ(reason(48), "no_board");
  EXPECT_EQ(reason(49), "telemetry_lost") << "50 ms, half of what is tolerated";
  EXPECT_EQ(reason(80), "telemetry_lost");
}

TEST(Absent, ABallThatIsSilentHasLostItsTelemetry) {
  Controlled ball{ControlSettings{}};
  ball.run(50);
  ball.inputs.board_fresh = false;
  ball.run(99);
  EXPECT_NE(name(ball.controller.state()), "absent");
  ball.step();
  EXPECT_EQ(name(ball.controller.state()), "absent");
  EXPECT_EQ(name(ball.controller.reason()), "telemetry_lost");
}

TEST(ArmingBlocker, ABoardsHeatLatchUntilTheBallIsCool) {
  for (const auto& [fault, blocker] : {std::pair{board::kOverHeat, "board_over_heat"},
                                       std::pair{board::kHeatBudget, "board_heat_budget"}}) {
    ControlSettings settings;
    settings.start_known = true;
    Controlled ball(settings);
    ball.inputs.board.sensor_c = 50.0;
    ball.inputs.board.mode = device::BoardMode::kLatched;
    ball.inputs.board.faults = static_cast<std::uint16_t>(fault);
    ball.run(50);
    EXPECT_EQ(name(ball.snapshot().arming_blocker), blocker);
    Controlled cool(settings);
    cool.inputs.board = ball.inputs.board;
    cool.inputs.board.sensor_c = 30.0;
    cool.run(50);
    EXPECT_EQ(name(cool.snapshot().arming_blocker), "none") << blocker;
  }
}

TEST(ArmingBlocker, ABoardThatMayStillEnterItsBootLoader) {
  Controlled ball{ControlSettings{}};
  ball.run(50);
  EXPECT_EQ(name(ball.snapshot().arming_blocker), "none");
  ball.command(EnterBootLoader{});
  EXPECT_EQ(name(ball.snapshot().arming_blocker), "boot_loader");
}

TEST(Trips, AGainOfACurrentThatTheSupplyContradictsIsNamed) {
  rig::Rig rig;
  device::SimulatorErrorList errors;
  errors.generation = 1;
  errors.count = 1;
  errors.error[0] = {device::SimulatorErrorKind::kCurrentGain, 2, 1.07, 0.0};
  rig.board().set_errors(errors);
  rig.run_until_armed();
  const auto effect = rig.start(rig::hold({0, 0, 1}, 12.0));
  for (int s = 0; s < 20 && rig.controller().state() == State::kArmed; ++s) {
    rig.update(effect, rig::hold({0, 0, 1}, 12.0));
    rig.run(1000);
  }
  EXPECT_EQ(name(rig.controller().reason()), "measurements_disagree");
  EXPECT_EQ(rig.controller().last_trip().disagreement,
            (Disagreement{2, Quantity::kCurrent, Quantity::kSupplyCurrent}));
}

TEST(Arming, RestartsTheTimeForWhichAFanMayStand) {
  rig::RigOptions options;
  options.control.arm_at_start = false;
  options.board.start_c = 44.0;
  rig::Rig rig(options);
  rig.set_faults(device::kSimFanStopped);
  rig.run(2900);
  ASSERT_GT(rig.last_command().fan, 0) << "a warm ball is cooled without being armed";
  rig.arm();
  rig.run(2800);
  EXPECT_EQ(name(rig.controller().state()), "armed");
  rig.run(400);
  EXPECT_EQ(name(rig.controller().reason()), "fan_stopped");
}

TEST(Limits, ApplyInTheTickOfTheRequestWithoutTelemetryToo) {
  ControlSettings settings;
  settings.start_known = true;
  settings.start_measured.fill(true);
  Controlled ball(settings);
  ball.run(50);
  EXPECT_EQ(ball.snapshot().limit_a, 15.0);
  ball.inputs.board_fresh = false;
  model::Limits limits;
  limits.current_a = limits.continuous_a = 3.0;
  ball.command(SetLimits{limits});
  EXPECT_EQ(ball.snapshot().limit_a, 3.0);
}

TEST(Effects, OneWithoutDeratingIsDeliveredInFull) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::pulse({0, 0, 1}, 5.0, 150));
  rig.run(300);
  const Event* end = rig.last(EventType::kEffectEnded);
  ASSERT_NE(end, nullptr);
  EXPECT_EQ(end->delivery.min, 1.0);
}

TEST(Effects, ARejectedNumberIsNoDemand) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, std::numeric_limits<double>::quiet_NaN()));
  rig.tick();
  EXPECT_EQ(rig.snapshot().demand_a, model::Vec3{});
}

TEST(Effects, StopsBeyondTheirCountAreOldOnes) {
  ControlSettings settings;
  settings.arm_at_start = settings.start_known = true;
  settings.start_measured.fill(true);
  Controlled ball(settings);
  ball.run(50);
  ball.inputs.stops[0] = {7, 3, EndReason::kStopped};
  StartEffect start{7, 3, 0, 0, rig::hold({1, 0, 0}, 2.0)};
  ball.command(start);
  for (const Event& event : ball.events) EXPECT_NE(event.end_reason, EndReason::kStopped);
}

TEST(Effects, AllEndWithTheGivenReason) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 2.0));
  rig.start(rig::hold({0, 1, 0}, 2.0));
  rig.run(20);
  Controller controller = rig.controller();
  EventList events;
  events.push({});
  controller.end_all(EndReason::kTripped, events);
  EXPECT_EQ(events.size(), 2u);
  for (const Event& event : events) {
    EXPECT_EQ(event.type, EventType::kEffectEnded);
    EXPECT_EQ(event.end_reason, EndReason::kTripped);
  }
  EXPECT_TRUE(controller.effects_empty());
}

}  // namespace
}  // namespace hedgehog::control
