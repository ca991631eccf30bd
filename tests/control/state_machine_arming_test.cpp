// SPDX-License-Identifier: MIT
// What ends an arming, and what prevents that of the start.
#include <gtest/gtest.h>

#include <utility>

#include "daemon/control/state/state_machine.h"

namespace hedgehog::control {
namespace {

device::BoardTelemetry board_in(device::BoardMode mode, std::uint8_t arm_count) {
  device::BoardTelemetry board;
  board.mode = mode;
  board.arm_count = arm_count;
  return board;
}
device::BoardTelemetry ready_with(std::uint8_t arm_count) {
  return board_in(device::BoardMode::kReady, arm_count);
}

/// Disarmed, and armed as soon as what prevents it is gone.
StateMachine waiting_to_arm() {
  ControlSettings settings;
  settings.arm_at_start = true;
  StateMachine states{settings};
  states.board_alive(ready_with(0), 1);
  states.step(ready_with(0), true, Reason::kSensorOpen, 2);
  EXPECT_FALSE(states.arming());
  return states;
}

TEST(StateMachine, ArmsAtTheStartOnceNothingPreventsIt) {
  StateMachine states = waiting_to_arm();
  states.step(ready_with(0), true, Reason::kNone, 3);
  EXPECT_TRUE(states.arming());
  states.step(ready_with(1), true, Reason::kNone, 4);
  EXPECT_TRUE(states.armed());
}

TEST(StateMachine, AnEmergencyStopOrBootLoaderPreventsTheArmingOfTheStart) {
  StateMachine stopped = waiting_to_arm();
  stopped.emergency_stop(3);
  stopped.step(ready_with(0), true, Reason::kNone, 4);
  EXPECT_FALSE(stopped.arming());
  StateMachine loading = waiting_to_arm();
  loading.enter_boot_loader(3);
  for (model::Tick t = 4; t < 4 + 2 * StateMachine::kBootLoaderTimeout; ++t) {
    loading.step(ready_with(0), true, Reason::kNone, t);
    ASSERT_FALSE(loading.arming()) << t;
  }
}

TEST(StateMachine, AfterATripARestartedBoardIsNotArmedByTheStart) {
  StateMachine states = waiting_to_arm();
  states.trip(Reason::kOverheated, 3);
  states.arm(Reason::kNone, 4);
  states.step(ready_with(1), true, Reason::kNone, 5);
  ASSERT_TRUE(states.armed());
  states.board_restarted(6);
  states.step(ready_with(0), true, Reason::kNone, 7);
  EXPECT_EQ(states.state(), State::kDisarmed);
  EXPECT_FALSE(states.arming());
}

TEST(StateMachine, ABoardThatIsGoneEndsAnArmingInProgress) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready_with(0), 1);
  states.arm(Reason::kNone, 2);
  states.board_gone(Reason::kNoBoard, 3);
  states.board_alive(ready_with(1), 4);
  states.step(ready_with(1), true, Reason::kNone, 5);
  EXPECT_FALSE(states.armed());
}

TEST(StateMachine, AnArmingThatTheBoardDoesNotConfirmInTimeIsOver) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready_with(0), 1);
  states.arm(Reason::kNone, 2);
  for (model::Tick t = 3; t <= 3 + StateMachine::kArmTimeout; ++t)
    states.step(ready_with(0), true, Reason::kNone, t);
  EXPECT_FALSE(states.arming());
  states.step(ready_with(1), true, Reason::kNone, 4 + StateMachine::kArmTimeout);
  EXPECT_FALSE(states.armed());
}

TEST(StateMachine, OnlyABoardThatIsReadyOrDrivesIsArmed) {
  for (const auto& [mode, armed] : {std::pair{device::BoardMode::kSafe, false},
                                    {device::BoardMode::kLatched, false},
                                    {device::BoardMode::kReady, true},
                                    {device::BoardMode::kDriving, true}}) {
    StateMachine states{ControlSettings{}};
    states.board_alive(ready_with(0), 1);
    states.arm(Reason::kNone, 2);
    states.step(board_in(mode, 1), true, Reason::kNone, 3);
    EXPECT_EQ(states.armed(), armed) << static_cast<int>(mode);
  }
}

TEST(StateMachine, AStateThatIsEnteredAgainKeepsItsTime) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready_with(0), 1);
  states.emergency_stop(5);
  states.emergency_stop(9);
  EXPECT_EQ(states.since(), 5);
}

TEST(StateMachine, FiveMinutesArmedDiscardOneArmingAfterATrip) {
  StateMachine states{ControlSettings{}};
  states.board_alive(ready_with(0), 1);
  states.trip(Reason::kSensorOpen, 2);
  states.arm(Reason::kNone, 3);
  states.step(ready_with(1), true, Reason::kNone, 4);
  const auto count = [&] { return states.rearms()[static_cast<std::size_t>(Reason::kSensorOpen)]; };
  ASSERT_EQ(count(), 1);
  states.step(ready_with(1), true, Reason::kNone, 4 + RearmBackoff::kResetAfter);
  states.step(ready_with(1), true, Reason::kNone, 5 + RearmBackoff::kResetAfter);
  EXPECT_EQ(count(), 0);
}

}  // namespace
}  // namespace hedgehog::control
