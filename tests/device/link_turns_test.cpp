// SPDX-License-Identifier: MIT
// Values that a board reports in turn, and frames that the link sends in turn.
#include "daemon/device/board_codec.h"
#include "tests/device/link_bench.h"

namespace hedgehog::device {
namespace {

struct LinkBenchTurns : LinkBench {
  LinkBenchTurns() { board.thermistors = 3; }
  // A frame that reports thermistor `k`.
  void turn(std::uint8_t k, std::int16_t cc) {
    board.other_thermistor = k;
    board.other_cc = cc;
    telemetry();
  }
  const Thermistor& thermistor(std::size_t k) const {
    return link.report().telemetry.thermistor[k];
  }
};

TEST_F(LinkBenchTurns, AThermistorKeepsItsReadingUntilItsNextTurn) {
  turn(1, 3100);
  EXPECT_EQ(thermistor(1).celsius, 31.0);
  EXPECT_EQ(thermistor(2).state, ThermistorState::kNone) << "it has had no turn";
  turn(2, 3200);
  EXPECT_EQ(thermistor(1).celsius, 31.0);
  EXPECT_EQ(thermistor(2).celsius, 32.0);
  turn(1, 3150);
  EXPECT_EQ(thermistor(1).celsius, 31.5);
  EXPECT_EQ(thermistor(2).celsius, 32.0);
}

TEST_F(LinkBenchTurns, AfterAHundredFramesWithoutATurnAThermistorIsUnknown) {
  turn(1, 3100);
  for (int frame = 1; frame < 100; ++frame) {
    turn(2, 3200);
    ASSERT_EQ(thermistor(1).state, ThermistorState::kRead) << frame;
  }
  turn(2, 3200);
  EXPECT_EQ(thermistor(1).state, ThermistorState::kNone);
  turn(2, 3200);
  EXPECT_EQ(thermistor(1).state, ThermistorState::kNone);
  turn(1, 3100);
  EXPECT_EQ(thermistor(1).state, ThermistorState::kRead);
}

TEST_F(LinkBenchTurns, AReadingFromBeforeAnAbsenceIsNotKept) {
  for (const int silent_ms : {Link::kAbsentTicks - 1, Link::kAbsentTicks}) {
    link = Link();
    turn(1, 3100);
    for (int ms = 0; ms < silent_ms; ++ms) step();
    turn(2, 3200);
    EXPECT_EQ(thermistor(1).state == ThermistorState::kRead, silent_ms < Link::kAbsentTicks);
    turn(2, 3200);
    EXPECT_EQ(thermistor(1).state == ThermistorState::kRead, silent_ms < Link::kAbsentTicks);
  }
}

TEST_F(LinkBenchTurns, AThermistorThatIsNotWiredIsNotKept) {
  turn(1, 3100);
  turn(2, 3200);
  board.thermistors = 2;
  turn(1, 3100);
  EXPECT_EQ(thermistor(1).state, ThermistorState::kRead);
  EXPECT_EQ(thermistor(2).state, ThermistorState::kNone);
}

TEST_F(LinkBenchTurns, AClockThatGoesBackByMoreThanTenSecondsIsARestart) {
  for (const std::uint32_t forward_ms : {10'000u, 10'001u}) {
    link = Link();
    board.board_ms = 0xFFFF'FFFFu - 5000u;
    telemetry();
    board.board_ms += forward_ms - 1u;
    telemetry();
    EXPECT_EQ(link.report().telemetry.board_ms, forward_ms - 5000u);
    EXPECT_EQ(link.report().telemetry.before.known, forward_ms == 10'000u)
        << "what a board said before it restarted belongs to another run";
  }
}

TEST_F(LinkBenchTurns, ABoardThatRestartsGetsTheLimitsWithTheNextFrame) {
  link = Link(BoardLimits{60.0, 8.0, 0.5});
  tick();
  tick();
  ASSERT_FALSE(frames.other);
  board.board_ms = 0xFFFF'0000u;
  telemetry();
  board.board_ms = 20'000u;
  tick();
  ASSERT_TRUE(frames.other);
  EXPECT_EQ(board::read_limits(frames.other->data()).current_ma, 8000);
}

TEST_F(LinkBenchTurns, AfterAnAbsenceAnyNumberAndClockMayFollow) {
  board.sequence = 1000;
  telemetry();
  for (int ms = 0; ms < Link::kAbsentTicks; ++ms) step();
  board.sequence = 10;
  board.board_ms += 60'000;
  telemetry();
  EXPECT_EQ(link.report().telemetry_count, 2u) << "it may be another board";
  EXPECT_EQ(link.report().counters.errors, 0u);
}

TEST_F(LinkBenchTurns, ForControlTheArmCountOfABoardThatRestartsGoesOn) {
  board.arm_count = 7;
  board.board_ms = 100'000;
  telemetry();
  board.board_ms = 0;
  board.arm_count = 3;
  telemetry();
  EXPECT_EQ(link.report().telemetry.arm_count, 7);
  board.arm_count = 4;
  telemetry();
  EXPECT_EQ(link.report().telemetry.arm_count, 8);
}

TEST_F(LinkBenchTurns, ContinuesFromWhatTheBoardHasReceivedAndNeverBack) {
  board.received_sequence = 1;
  telemetry();
  step();
  EXPECT_EQ(set_point().sequence, 2u);
  step();
  telemetry();
  step();
  EXPECT_EQ(set_point().sequence, 4u) << "the board has heard less than was sent";
}

TEST_F(LinkBenchTurns, TheLimitsAreRepeatedEverySecond) {
  link = Link(BoardLimits{60.0, 8.0, 0.5});
  tick();
  ASSERT_TRUE(frames.other);
  for (int ms = 1; ms < 1000; ++ms) {
    tick();
    ASSERT_FALSE(frames.other) << ms;
  }
  tick();
  EXPECT_TRUE(frames.other);
}

TEST_F(LinkBenchTurns, ASimulatedBoardsPlantStateIsForwardedAndIsNoTelemetry) {
  PlantTruth truth;
  truth.core_c = 31.5;
  link.receive(encode_truth(truth, 1));
  EXPECT_TRUE(link.truth().known);
  EXPECT_EQ(link.truth().core_c, 31.5);
  EXPECT_EQ(link.report().counters.errors, 0u);
  EXPECT_EQ(link.report().telemetry_count, 0u);
}

TEST_F(LinkBenchTurns, CountsTheFramesItSends) {
  link = Link(BoardLimits{60.0, 8.0, 0.5});
  tick();
  EXPECT_EQ(link.report().counters.frames_out, 2u) << "a set-point and the limits";
  board::FrameHeader header;
  board::read_header(frames.other->data(), frames.other->size(), header);
  EXPECT_EQ(header.sequence, set_point().sequence + 1) << "the board refuses what is not newer";
  tick();
  EXPECT_EQ(link.report().counters.frames_out, 3u);
}

TEST_F(LinkBenchTurns, WithoutABoardOrBeforeTheFirstCommandTheFanIsAsCommanded) {
  command.board.fan = 42;
  telemetry();
  step();
  EXPECT_EQ(set_point().fan, 42) << "control has not begun, it is not stuck";
  link = Link();
  ++command.count;
  step();
  EXPECT_EQ(set_point().fan, 42) << "no board is no fault of control";
}

TEST_F(LinkBenchTurns, ReadsLimitsAndSettingsFromThePort) {
  LinkPort port;
  port.limits.write({60.0, 8.0, 0.5});
  telemetry();
  frames = link.step(port);
  ASSERT_TRUE(frames.other);
  EXPECT_EQ(board::read_limits(frames.other->data()).current_ma, 8000);
  SimulatorSettings settings;
  settings.faults = kSimFanStopped;
  port.simulator.write(settings);
  frames = link.step(port);
  ASSERT_TRUE(frames.other);
  EXPECT_EQ(decode_simulator(*frames.other), settings);
}

TEST_F(LinkBenchTurns, ChangedSettingsAreSentFromTheirBeginning) {
  SimulatorSettings settings;
  settings.errors.count = 2;
  link.set_simulator(settings);
  telemetry();
  step();
  step();
  settings.faults = kSimFanStopped;
  link.set_simulator(settings);
  step();
  ASSERT_TRUE(frames.other);
  board::FrameHeader header;
  board::read_header(frames.other->data(), frames.other->size(), header);
  EXPECT_EQ(header.type, board::FrameType::kSimulator);
}

TEST_F(LinkBenchTurns, SimulatedErrorsFollowTheSettingsOneAFrame) {
  SimulatorSettings settings;
  settings.errors.count = 2;
  settings.errors.error[0].value = 0.25;
  settings.errors.error[1].value = 0.5;
  link.set_simulator(settings);
  telemetry();
  std::uint32_t last = 0;
  for (int round = 0; round < 2; ++round) {
    for (int part = 0; part < 3; ++part) {
      step();
      ASSERT_TRUE(frames.other) << part;
      board::FrameHeader header;
      board::read_header(frames.other->data(), frames.other->size(), header);
      EXPECT_GT(header.sequence, last);
      last = header.sequence;
      if (part == 0) {
        EXPECT_EQ(header.type, board::FrameType::kSimulator);
        continue;
      }
      ASSERT_EQ(header.type, board::FrameType::kSimulatorError);
      const board::SimulatorErrorFrame error = board::read_simulator_error(frames.other->data());
      EXPECT_EQ(error.index, part - 1);
      EXPECT_EQ(error.value_millionths, part * 250'000);
    }
    for (int ms = 0; ms < 99; ++ms) {
      step();
      ASSERT_FALSE(frames.other) << ms;
    }
  }
}

}  // namespace
}  // namespace hedgehog::device
