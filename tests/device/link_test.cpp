// SPDX-License-Identifier: MIT

#include "tests/device/link_bench.h"

namespace hedgehog::device {
namespace {

TEST_F(LinkBench, ForwardsAFreshSetPoint) {
  tick();
  EXPECT_TRUE(set_point().enable);
  EXPECT_EQ(set_point().duty_q15[0], command.board.duty_q15()[0]);
}

TEST_F(LinkBench, NumbersItsFrames) {
  tick();
  const std::uint32_t first = set_point().sequence;
  tick();
  EXPECT_EQ(set_point().sequence, first + 1);
}

TEST_F(LinkBench, ASetPointIsRepeatedForNineteenTicksAndThenReplacedByTheSafeCommand) {
  tick();
  for (int i = 1; i < Link::kOverdueTicks; ++i) {
    telemetry();
    step();
    ASSERT_TRUE(set_point().enable) << i;
  }
  EXPECT_EQ(link.report().counters.overdue, 0u);
  telemetry();
  step();
  EXPECT_FALSE(set_point().enable);
  EXPECT_EQ(set_point().duty_q15[0], 0);
  EXPECT_EQ(set_point().fan, 255) << "control is stuck";
  for (int i = 0; i < 50; ++i) {
    telemetry();
    step();
    ASSERT_FALSE(set_point().enable);
  }
  EXPECT_EQ(link.report().counters.overdue, 1u) << "an episode counts once";
  tick();
  EXPECT_TRUE(set_point().enable);
}

TEST_F(LinkBench, ReportsWhenASetPointWasFirstWritten) {
  tick();
  EXPECT_EQ(link.report().written_count, 0u);
  link.set_written(1000);
  EXPECT_EQ(link.report().written_count, command.count);
  EXPECT_EQ(link.report().written_ns, 1000);
  telemetry();
  step();  // the same command again
  link.set_written(2000);
  EXPECT_EQ(link.report().written_ns, 1000);
  tick();
  link.set_written(3000);
  EXPECT_EQ(link.report().written_count, command.count);
  EXPECT_EQ(link.report().written_ns, 3000);
}

TEST_F(LinkBench, TheSafeCommandIsNoSetPointOfControls) {
  for (int i = 0; i <= Link::kOverdueTicks; ++i) step();
  link.set_written(1000);
  EXPECT_EQ(link.report().written_count, 0u);
}

TEST_F(LinkBench, ARepeatedSetPointHasNoBoost) {
  telemetry();
  renew();
  command.board = BoardCommand::drive(limited({5, 0, 0}), kColdOhm, 1.5e-3, {0, 0, 0}, 12.0);
  step();
  ASSERT_GT(command.board.boost_q15()[0], 0);
  EXPECT_EQ(set_point().boost_q15[0], command.board.boost_q15()[0]);
  for (int i = 1; i < Link::kOverdueTicks; ++i) {
    telemetry();
    step();
    ASSERT_EQ(set_point().boost_q15[0], 0) << i;
    ASSERT_EQ(set_point().duty_q15[0], command.board.duty_q15()[0]) << i;
  }
}

TEST_F(LinkBench, WithoutABoardOnlyTheSafeCommandIsSent) {
  renew();
  step();
  EXPECT_FALSE(set_point().enable);
  EXPECT_FALSE(link.report().present);
  tick();
  EXPECT_TRUE(link.report().present);
  EXPECT_TRUE(set_point().enable);
}

TEST_F(LinkBench, ABoardThatIsSilentForAHundredTicksIsAbsent) {
  tick();
  for (int i = 1; i < Link::kAbsentTicks; ++i) {
    renew();
    step();
    ASSERT_TRUE(link.report().present) << i;
  }
  renew();
  step();
  EXPECT_FALSE(link.report().present);
  EXPECT_FALSE(set_point().enable);
}

// A link thread that runs in every tenth millisecond only.
TEST_F(LinkBench, SkippedTicksCount) {
  link = Link(BoardLimits{60.0, 8.0, 0.5});
  const auto tenth = [&] {
    link.skip(9);
    step();
  };
  tick();
  tick();
  int limits = 0;
  for (int i = 1; i < 10; ++i) {
    tenth();
    EXPECT_EQ(set_point().enable, i < 2) << i;
    EXPECT_TRUE(link.report().present) << i;
  }
  EXPECT_EQ(link.report().counters.overdue, 1u);
  tenth();
  EXPECT_FALSE(link.report().present) << "silent for 100 ms";

  for (int i = 0; i < 300; ++i) {
    link.skip(9);
    telemetry();
    step();
    EXPECT_TRUE(link.report().present) << "what came in a gap is heard";
    if (frames.other) ++limits;
  }
  EXPECT_EQ(limits, 3) << "every second";

  ++command.board.arm_count;
  int requests = 0;
  for (int i = 0; i < 20; ++i) {
    link.skip(9);
    telemetry();
    step();
    if (arm_request()) ++requests;
  }
  EXPECT_EQ(requests, 5) << "for 50 ms";
}

TEST_F(LinkBench, CountsLostAndCorruptFrames) {
  tick();
  board.sequence += 4;
  tick();
  EXPECT_EQ(link.report().counters.lost, 4u);
  Frame frame;
  board::write_frame(board, frame.data());
  frame[30] ^= 4;
  link.receive(frame);
  link.receive(std::span(frame).first(10));
  EXPECT_EQ(link.report().counters.errors, 2u);
  EXPECT_EQ(link.report().counters.frames_in, 2u);
  EXPECT_EQ(link.report().telemetry_count, 2u);
}

TEST_F(LinkBench, RepeatedTelemetryIsNotNew) {
  tick();
  send(board);
  EXPECT_EQ(link.report().telemetry_count, 1u);
  EXPECT_EQ(link.report().counters.errors, 1u);
}

TEST_F(LinkBench, ABoardThatWasAwayMayCountFromTheBeginning) {
  for (int i = 0; i < 50; ++i) tick();
  for (int i = 0; i < Link::kAbsentTicks + 1; ++i) step();
  ASSERT_FALSE(link.report().present);
  board = {};
  tick();
  EXPECT_EQ(link.report().telemetry_count, 51u);
  EXPECT_TRUE(link.report().present);
  EXPECT_EQ(link.report().counters.lost, 0u);
  EXPECT_EQ(link.report().counters.errors, 0u);
}

TEST_F(LinkBench, NumbersFromBeforeAnAbsenceAreNotLostFrames) {
  tick();
  for (int i = 0; i < Link::kAbsentTicks + 1; ++i) step();
  board.sequence += 1'000'000;
  tick();
  EXPECT_TRUE(link.report().present);
  EXPECT_EQ(link.report().counters.lost, 0u);
}

TEST_F(LinkBench, AnotherProtocolVersionIsAnAbsentBoard) {
  tick();
  ASSERT_TRUE(link.report().present);
  send_of_another_version();
  renew();
  step();
  EXPECT_FALSE(link.report().present);
  EXPECT_FALSE(set_point().enable);
}

TEST_F(LinkBench, ContinuesFromTheNumberThatTheBoardHasReceived) {
  board.received_sequence = 5'000'000;
  tick();
  EXPECT_EQ(set_point().sequence, 5'000'001u);
}

// -- arming -------------------------------------------------------------------------------------

TEST_F(LinkBench, LimitsAreSentToEveryBoardThatAppears) {
  link = Link(BoardLimits{60.0, 8.0, 0.5});
  int sent = 0;
  for (int appearance = 0; appearance < 2; ++appearance) {
    tick();
    ASSERT_TRUE(frames.other);
    EXPECT_EQ(board::read_limits(frames.other->data()).current_ma, 8000);
    ++sent;
    for (int i = 0; i < Link::kAbsentTicks + 1; ++i) step();
  }
  EXPECT_EQ(sent, 2);
}

// 2^31 milliseconds without a board.
TEST_F(LinkBench, TimersStillExpireAfterTwentyFiveDays) {
  link = Link(BoardLimits{60.0, 8.0, 0.5});
  link.set_simulator({});
  for (int i = 0; i < 2'148'000; ++i) link.skip(1000);
  step();
  ASSERT_TRUE(frames.other);
  EXPECT_EQ(decode_simulator(*frames.other), SimulatorSettings{});
}

TEST_F(LinkBench, SimulatorSettingsAreSentWhenTheyChangeAndEveryHundredTicks) {
  SimulatorSettings settings;
  int sent = 0;
  for (int i = 0; i < 250; ++i) {
    telemetry();
    renew();
    if (i == 50) settings.faults = kSimFanStopped;
    link.set_simulator(settings);
    step();
    if (!frames.other) continue;
    ++sent;
    EXPECT_EQ(decode_simulator(*frames.other), settings);
    EXPECT_TRUE(i == 0 || i == 50 || i > 140) << i;
  }
  EXPECT_GE(sent, 3);
  EXPECT_LE(sent, 4);
}

}  // namespace
}  // namespace hedgehog::device
