// SPDX-License-Identifier: MIT
// States and their names, fan, heading and the lateness statistics.
#include "daemon/control/state/state.h"

#include <gtest/gtest.h>

#include "daemon/control/heading.h"
#include "daemon/control/loop/lateness.h"
#include "daemon/control/state/state_machine.h"
#include "model/thermal/fan.h"

namespace hedgehog::control {
namespace {

device::BoardTelemetry ready(std::uint8_t arm_count) {
  device::BoardTelemetry board;
  board.mode = device::BoardMode::kReady;
  board.arm_count = arm_count;
  return board;
}

TEST(Names, EveryReasonHasOneAndIsFoundByIt) {
  for (int i = 0; i <= static_cast<int>(Reason::kBootLoader); ++i) {
    const auto reason = static_cast<Reason>(i);
    EXPECT_EQ(reason_named(name(reason)), reason);
  }
  EXPECT_EQ(name(Reason::kSensorFrozen), "sensor_frozen");
  EXPECT_EQ(reason_named("nonsense"), Reason::kNone);
}

TEST(StateMachine, ArmsOnlyWhenTheBoardConfirmsTheRequestedCount) {
  StateMachine states{ControlSettings{}};
  EXPECT_EQ(states.state(), State::kAbsent);
  states.board_alive(ready(41), 1);
  EXPECT_EQ(states.state(), State::kDisarmed);
  EXPECT_EQ(states.arm_count(), 41) << "the first set-point must arm nothing";
  states.arm(Reason::kNone, 2);
  EXPECT_EQ(states.arm_count(), 42);
  states.step(ready(41), true, Reason::kNone, 3);
  EXPECT_FALSE(states.armed());
  states.step(ready(42), false, Reason::kNone, 4);
  EXPECT_FALSE(states.armed()) << "old news";
  states.step(ready(42), true, Reason::kNone, 5);
  EXPECT_TRUE(states.armed());
  EXPECT_EQ(states.since(), 5);
}

TEST(StateMachine, ABoardThatNeverConfirmsIsNotArmed) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready(0), 1);
  states.arm(Reason::kNone, 2);
  device::BoardTelemetry latched;
  latched.mode = device::BoardMode::kLatched;
  latched.faults = board::kBridge;
  for (model::Tick t = 3; t < 1000; ++t) states.step(latched, true, Reason::kNone, t);
  EXPECT_EQ(states.state(), State::kTripped);
  EXPECT_EQ(states.reason(), Reason::kBridgeFault);
  states.step(ready(1), true, Reason::kNone, 1001);
  EXPECT_FALSE(states.armed()) << "the arming is over";
}

TEST(StateMachine, ARefusalEndsTheArming) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready(0), 1);
  states.arm(Reason::kSensorOpen, 2);
  EXPECT_EQ(states.arm_count(), 0);
}

TEST(StateMachine, TheFirstTripOfAnEpisodeStays) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready(0), 1);
  states.trip(Reason::kOverheated, 2);
  states.trip(Reason::kSensorOpen, 3);
  EXPECT_EQ(states.reason(), Reason::kOverheated);
  EXPECT_EQ(states.since(), 2);
  states.emergency_stop(4);
  EXPECT_EQ(states.state(), State::kTripped) << "an emergency stop does not loosen a trip";
  EXPECT_EQ(states.latch(), Reason::kOverheated);
}

TEST(StateMachine, AnEmergencyStopEndsAnArmingInProgress) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready(0), 1);
  states.arm(Reason::kNone, 2);
  states.emergency_stop(2);
  for (model::Tick t = 3; t < 10; ++t) states.step(ready(1), true, Reason::kNone, t);
  EXPECT_EQ(states.state(), State::kDisarmed);
  EXPECT_EQ(states.latch(), Reason::kEmergencyStop);
}

TEST(StateMachine, ATripEndsAnArmingInProgress) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready(0), 1);
  states.arm(Reason::kNone, 2);
  states.trip(Reason::kUnexpectedCurrent, 2);
  for (model::Tick t = 3; t < 10; ++t) states.step(ready(1), true, Reason::kNone, t);
  EXPECT_EQ(states.state(), State::kTripped);
}

TEST(StateMachine, AnEmergencyStopWhileAbsentIsLatched) {
  ControlSettings settings;
  settings.arm_at_start = true;
  StateMachine states{settings};
  states.emergency_stop(1);
  EXPECT_EQ(states.state(), State::kAbsent);
  states.board_alive(ready(0), 2);
  states.step(ready(0), true, Reason::kNone, 3);
  EXPECT_EQ(states.state(), State::kDisarmed);
  EXPECT_EQ(states.reason(), Reason::kEmergencyStop);
}

TEST(StateMachine, AnEmergencyStopWhileAbsentDoesNotReplaceATrip) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready(0), 1);
  states.trip(Reason::kOverheated, 2);
  states.board_gone(Reason::kTelemetryLost, 3);
  states.emergency_stop(4);
  EXPECT_EQ(states.latch(), Reason::kOverheated);
  states.board_alive(ready(0), 5);
  EXPECT_EQ(states.state(), State::kTripped);
  EXPECT_EQ(states.reason(), Reason::kOverheated) << "arming still waits until it is cool";
}

TEST(StateMachine, ABoardInItsBootLoaderIsAbsentForThatReasonAndThenAHotPlug) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready(0), 1);
  states.enter_boot_loader(2);
  EXPECT_EQ(states.boot_loader_count(), 1);
  states.arm(Reason::kNone, 3);
  EXPECT_FALSE(states.arming()) << "the board may be gone in a moment";
  states.board_gone(Reason::kTelemetryLost, 4);
  EXPECT_EQ(states.state(), State::kAbsent);
  EXPECT_EQ(states.reason(), Reason::kBootLoader);
  EXPECT_EQ(states.latch(), Reason::kNone);
  states.board_gone(Reason::kNoBoard, 5);
  EXPECT_EQ(states.reason(), Reason::kBootLoader);
  states.board_alive(ready(0), 6);
  EXPECT_EQ(states.reason(), Reason::kHotPlug);
  states.board_gone(Reason::kNoBoard, 7);
  EXPECT_EQ(states.reason(), Reason::kNoBoard) << "nobody asked for that";
}

TEST(StateMachine, TheBootLoaderIsForABoardThatIsNeitherArmedNorBeingArmed) {
  StateMachine states{ControlSettings{}};
  states.enter_boot_loader(1);
  EXPECT_EQ(states.boot_loader_count(), 0) << "there is none";
  states.board_alive(ready(0), 1);
  states.arm(Reason::kNone, 2);
  states.enter_boot_loader(3);
  states.step(ready(1), true, Reason::kNone, 4);
  ASSERT_TRUE(states.armed());
  states.enter_boot_loader(5);
  EXPECT_EQ(states.boot_loader_count(), 0);
  states.trip(Reason::kOverheated, 6);
  states.enter_boot_loader(7);
  EXPECT_EQ(states.boot_loader_count(), 1);
  states.board_gone(Reason::kNoBoard, 8);
  states.board_alive(ready(0), 9);
  EXPECT_EQ(states.state(), State::kTripped) << "new firmware does not loosen a trip";
}

TEST(StateMachine, ABoardThatDoesNotEnterItCanBeArmedAfterATimeout) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready(0), 1);
  states.enter_boot_loader(2);
  const model::Tick end = 2 + StateMachine::kBootLoaderTimeout;
  states.step(ready(0), true, Reason::kNone, end);
  EXPECT_TRUE(states.boot_loader_pending());
  states.step(ready(0), true, Reason::kNone, end + 1);
  EXPECT_FALSE(states.boot_loader_pending());
  states.arm(Reason::kNone, end + 2);
  EXPECT_TRUE(states.arming());
}

TEST(StateMachine, ABoardThatAppearsLongAfterTheStartIsAHotPlug) {
  ControlSettings settings;
  settings.arm_at_start = true;
  for (const model::Tick appears_at :
       {model::Tick{1}, settings.start_timeout, settings.start_timeout + 1}) {
    const bool in_time = appears_at <= settings.start_timeout;
    StateMachine states{settings};
    states.board_gone(Reason::kNoBoard, 0);
    states.board_alive(ready(0), appears_at);
    for (model::Tick t = appears_at; t < appears_at + 10; ++t)
      states.step(ready(states.arm_count()), true, Reason::kNone, t);
    EXPECT_EQ(states.armed(), in_time);
    EXPECT_EQ(states.reason(), in_time ? Reason::kNone : Reason::kHotPlug);
  }
}

TEST(StateMachine, AReappearanceIsAHotPlug) {
  ControlSettings settings;
  settings.arm_at_start = true;
  StateMachine states{settings};
  states.board_alive(ready(0), 1);
  states.board_gone(Reason::kNoBoard, 2);
  states.board_gone(Reason::kTelemetryLost, 3);
  EXPECT_EQ(states.reason(), Reason::kNoBoard);
  states.board_alive(ready(0), 4);
  states.step(ready(0), true, Reason::kNone, 5);
  EXPECT_EQ(states.state(), State::kDisarmed);
  EXPECT_EQ(states.reason(), Reason::kHotPlug);
  EXPECT_EQ(states.latch(), Reason::kNone);
}

TEST(Fan, FullAboveFortyOffBelowThirtyFive) {
  model::Fan fan;
  EXPECT_EQ(fan.step(40.0, 0.0, 1e-3), 0);
  EXPECT_EQ(fan.step(40.1, 0.0, 1e-3), 255);
  EXPECT_EQ(fan.step(35.0, 0.0, 1e-3), 255);
  EXPECT_EQ(fan.step(34.9, 0.0, 1e-3), 0);
  EXPECT_EQ(fan.step(39.9, 0.0, 1e-3), 0);
  EXPECT_EQ(fan.step(std::numeric_limits<double>::infinity(), 0.0, 1e-3), 255);
  EXPECT_EQ(model::Fan().step(std::numeric_limits<double>::quiet_NaN(), 0.0, 1e-3), 255);
}

TEST(Fan, FullWhenTheMeanOfHalfAMinuteIsAboveThreeAmpere) {
  model::Fan fan;
  int ticks = 0;
  while (fan.step(25.0, 5.0, 1e-3) == 0 && ticks < 100'000) ++ticks;
  EXPECT_NEAR(ticks * 1e-3, 30.0 * std::log(5.0 / 2.0), 0.1);
  EXPECT_NEAR(fan.mean_a(), 3.0, 1e-3);
  while (fan.step(25.0, 2.9, 1e-3) == 255 && ticks < 1'000'000) ++ticks;
  EXPECT_LT(fan.mean_a(), 3.0);
}

TEST(Heading, FreshForAHundredTicksAndRefusesInvalidRotations) {
  Heading heading;
  device::OrientationSample sample;
  heading.step(sample, 5);
  EXPECT_FALSE(heading.present());
  sample.present = true;
  sample.quaternion = {0.0, 0.0, 0.0, 0.0};
  sample.stamp = 10;
  heading.step(sample, 10);
  EXPECT_FALSE(heading.present());
  sample.quaternion = model::axis_angle({0, 0, 1}, 30.0);
  heading.step(sample, 110);
  EXPECT_TRUE(heading.fresh());
  heading.step(sample, 111);
  EXPECT_FALSE(heading.fresh());
  EXPECT_TRUE(heading.present());
  EXPECT_EQ(heading.age(), 101);
}

TEST(Heading, RecentreKeepsUpAndTurnsTheFront) {
  Heading heading;
  device::OrientationSample sample;
  sample.present = true;
  sample.quaternion = model::axis_angle({0, 0, 1}, 70.0) * model::axis_angle({0, 1, 0}, 40.0);
  heading.step(sample, 0);
  const model::Vec3 up = rotate(heading.device_to_world(), {0, 0, 1});
  heading.recenter(0.0);
  const model::Vec3 front = rotate(heading.device_to_world(), {1, 0, 0});
  EXPECT_NEAR(std::atan2(front.y, front.x), 0.0, 1e-12);
  EXPECT_NEAR(rotate(heading.device_to_world(), {0, 0, 1}).z, up.z, 1e-12);
  EXPECT_NEAR(heading.yaw_offset_deg(), -70.0, 1e-9);
}

TEST(Lateness, Quantiles) {
  Lateness lateness;
  EXPECT_EQ(lateness.summary().p50_us, 0.0);
  for (int i = 0; i < 1000; ++i) lateness.add(i < 990 ? 10'500 : 400'500);
  lateness.add(3'000'000);
  const Lateness::Summary summary = lateness.summary();
  EXPECT_EQ(summary.p50_us, 11.0);
  EXPECT_EQ(summary.p99_us, 401.0);
  EXPECT_EQ(summary.max_us, 3000.0);
}

}  // namespace
}  // namespace hedgehog::control
