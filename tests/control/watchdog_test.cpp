// SPDX-License-Identifier: MIT
// The whole watchdog: which fault counts in which state, and which one is reported first.
#include "tests/control/watched.h"

#include <gtest/gtest.h>

namespace hedgehog::control {
namespace {

TEST(Watchdog, AHealthyBallAtRestIsNoFault) {
  Watched ball;
  EXPECT_EQ(ball.run(20'000), Reason::kNone);
  EXPECT_EQ(ball.watchdog.arming_blocker(), Reason::kNone);
}

TEST(Watchdog, ADisarmedBallTripsOnlyByHeatStuckBridgeAndUnexpectedCurrent) {
  const auto reason_of = [](std::uint16_t faults, bool armed) {
    Watched ball;
    ball.armed = armed;
    ball.board.faults = faults;
    return ball.run(100);
  };
  EXPECT_EQ(reason_of(board::kStuckBridge, false), Reason::kBoardStuckBridge);
  EXPECT_EQ(reason_of(board::kUnexpectedCurrent, false), Reason::kUnexpectedCurrent);
  EXPECT_EQ(reason_of(board::kSupply, false), Reason::kNone);
  EXPECT_EQ(reason_of(board::kSupply, true), Reason::kBoardSupply);
  Watched hot;
  hot.board.sensor_c = 71.0;
  hot.armed = false;
  EXPECT_EQ(hot.run(100), Reason::kOverheated);
  Watched stuck;
  stuck.board.current_a = {0.0, 1.0, 0.0};
  stuck.armed = false;
  EXPECT_EQ(stuck.run(100), Reason::kUnexpectedCurrent);
}

TEST(Watchdog, TheBoardsOwnFaultIsNamedBeforeItsConsequences) {
  Watched ball;
  ball.run(100);
  ball.board.current_a = {0.0, 3.0, 0.0};
  ball.run(14);
  ball.board.faults = board::kBridge;
  EXPECT_EQ(ball.step(), Reason::kBridgeFault);
}

TEST(Watchdog, ASupplyCurrentThatContradictsTheWindingsIsADisagreement) {
  EXPECT_EQ(name(driven({8, 5, 6}, 1.0).run(3000)), "none");
  Watched ball = driven({8, 5, 6}, 0.8);
  EXPECT_EQ(name(ball.run(3000)), "measurements_disagree");
  EXPECT_TRUE(ball.watchdog.disagreement().has(Quantity::kSupplyCurrent));
}

TEST(Watchdog, TheSupplyIsComparedWithMeasuredCurrentsOnly) {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    Watched ball = driven({8, 5, 6}, 0.8);
    ball.board.measured[static_cast<std::size_t>(coil)] = false;
    EXPECT_EQ(name(ball.run(3000)), "none") << coil;
  }
  Watched unknown = driven({8, 5, 6}, 0.8);
  unknown.board.supply_current_known = false;
  EXPECT_EQ(name(unknown.run(3000)), "none");
}

TEST(Watchdog, ASleepingBoardIsExpectedToCarryNoCurrent) {
  for (const auto mode : {device::BoardMode::kSafe, device::BoardMode::kLatched}) {
    Watched ball;
    ball.commanded = device::BoardCommand();
    ball.board.mode = mode;
    EXPECT_EQ(ball.run(200), Reason::kNone);
  }
}

TEST(Watchdog, EachWiredThermistorIsReadAndWithOneOnlyItsWinding) {
  Watched one;
  one.step();
  const model::ThermalModel thermal;
  for (int coil = 0; coil < model::kCoils; ++coil)
    EXPECT_EQ(one.watchdog.thermistors().valid[static_cast<std::size_t>(coil)],
              coil == thermal.sensor_winding);
  for (int wrong = 0; wrong < model::kCoils; ++wrong) {
    Watched three;
    three.board.thermistors = 3;
    for (auto& thermistor : three.board.thermistor)
      thermistor = {device::ThermistorState::kRead, 31.0};
    three.step();
    const auto w = static_cast<std::size_t>(wrong);
    EXPECT_TRUE(three.watchdog.thermistors().valid[w]);
    EXPECT_EQ(three.watchdog.thermistors().celsius[w], 31.0);
    for (const double impossible_c : {-20.1, 125.0}) {
      three.board.thermistor[w].celsius = impossible_c;
      three.step();
      EXPECT_FALSE(three.watchdog.thermistors().valid[w]) << impossible_c;
    }
    three.board.thermistor[w] = {device::ThermistorState::kOpen, 31.0};
    three.step();
    EXPECT_FALSE(three.watchdog.thermistors().valid[w]);
  }
}

TEST(Watchdog, OfTwoThermistorsBothAreRead) {
  Watched two;
  two.board.thermistors = 2;
  two.board.thermistor[0] = {device::ThermistorState::kRead, 31.0};
  two.board.thermistor[1] = {device::ThermistorState::kRead, 32.0};
  two.step();
  EXPECT_EQ(two.watchdog.thermistors().valid, (std::array<bool, 3>{true, true, false}));
  EXPECT_EQ(two.watchdog.thermistors().celsius[1], 32.0);
}

TEST(Watchdog, AFrameCountsOnceHoweverLongItIsTheLast) {
  Watched ball;
  ball.run(10);
  ball.board.sensor_c = 71.0;
  ball.armed = false;
  ball.step();
  ball.fresh = false;
  EXPECT_EQ(ball.run(90), Reason::kNone);
  ball.fresh = true;
  EXPECT_EQ(ball.run(100), Reason::kOverheated);
}

TEST(Watchdog, ABrokenWireCountsByTheBoardsFaultOrByTheReading) {
  for (const auto& [fault, named] : {std::pair{board::kSensorOpen, Reason::kSensorOpen},
                                     std::pair{board::kSensorShort, Reason::kSensorShort}}) {
    Watched ball;
    ball.armed = false;
    ball.board.faults = static_cast<std::uint16_t>(fault);
    ball.step();
    EXPECT_EQ(ball.watchdog.arming_blocker(), named);
    const auto own = static_cast<std::size_t>(model::ThermalModel{}.sensor_winding);
    EXPECT_FALSE(ball.watchdog.thermistors().valid[own]) << "although it reads 25 C";
    ball.board.mode = device::BoardMode::kLatched;
    ball.run(100);
    EXPECT_EQ(ball.watchdog.arming_blocker(), Reason::kNone) << "the wire was broken and is whole";
    ball.board.sensor_c = 126.0;
    ball.step();
    EXPECT_EQ(ball.watchdog.arming_blocker(), named) << "it still reads impossibly";
  }
  for (const auto& [state, named] :
       {std::pair{device::ThermistorState::kOpen, Reason::kSensorOpen},
        std::pair{device::ThermistorState::kShorted, Reason::kSensorShort}}) {
    Watched ball;
    ball.board.thermistors = 3;
    ball.board.thermistor.fill({device::ThermistorState::kRead, 25.0});
    ball.step();
    const auto own = static_cast<std::size_t>(model::ThermalModel{}.sensor_winding);
    ball.board.thermistor[own].state = state;
    EXPECT_EQ(ball.run(100), named);
  }
}

TEST(Watchdog, ASilentBoardBlocksArmingBeforeItTrips) {
  Watched ball;
  EXPECT_EQ(ball.watchdog.arming_blocker(), Reason::kNoBoard);
  ball.step();
  EXPECT_EQ(ball.watchdog.arming_blocker(), Reason::kNone);
  ball.fresh = false;
  ball.step(100);
  EXPECT_EQ(ball.watchdog.arming_blocker(), Reason::kNoBoard);
}

TEST(Watchdog, AnUnrequestedCurrentBlocksArmingBeforeItTrips) {
  Watched ball;
  ball.run(10);
  ball.board.current_a = {0.0, 0.0, 2.0};
  EXPECT_EQ(ball.step(), Reason::kNone);
  EXPECT_EQ(ball.watchdog.arming_blocker(), Reason::kUnexpectedCurrent);
}

TEST(Watchdog, LostFramesCountWithTheNextOneUpToTwentyMilliseconds) {
  Watched ball;
  ball.run(10);
  ball.board.thermistors = 3;
  ball.board.thermistor.fill({device::ThermistorState::kOpen, 25.0});
  ball.fresh = false;
  ball.step(1);
  ball.step(1);
  ball.fresh = true;
  // Three milliseconds in one frame count as a third of the five, then each as one.
  int frames = 1;
  while (ball.step() == Reason::kNone && frames < 100) ++frames;
  EXPECT_EQ(frames, 4);
}

// Arming clears the board's latch; no other fault is ignored during it.
TEST(Watchdog, WhileArmingOnlyTheBoardsOwnLatchIsIgnored) {
  Watched latched;
  latched.arming = true;
  latched.board.mode = device::BoardMode::kLatched;
  latched.board.faults = board::kStuckBridge;
  EXPECT_EQ(latched.run(100), Reason::kNone);
  latched.arming = false;
  EXPECT_EQ(latched.run(100), Reason::kBoardStuckBridge);
  Watched hot;
  hot.arming = true;
  hot.armed = false;
  hot.board.sensor_c = 71.0;
  EXPECT_EQ(hot.run(100), Reason::kOverheated);
}

}  // namespace
}  // namespace hedgehog::control
