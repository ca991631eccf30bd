// SPDX-License-Identifier: MIT
// The host's end of the wire, tick by tick.
#include "daemon/device/link.h"

#include <gtest/gtest.h>

#include "daemon/device/board_core/crc32.h"
#include "tests/device/limited.h"

namespace hedgehog::device {
namespace {

struct LinkBench : testing::Test {
  Link link;
  LinkCommand command;
  board::TelemetryFrame board;
  LinkFrames frames;

  void telemetry() {
    ++board.sequence;
    ++board.board_ms;
    send(board);
  }
  void send(const board::TelemetryFrame& values) {
    Frame frame;
    board::write_frame(values, frame.data());
    link.receive(frame);
  }
  void send_of_another_version() {
    Frame frame;
    board::write_frame(board, frame.data());
    frame[1] = board::kProtocolVersion + 1;
    const std::uint32_t crc = board::crc32(frame.data(), 60);
    for (std::size_t i = 0; i < 4; ++i) frame[60 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    link.receive(frame);
  }
  // A new command from control, driving.
  void renew() {
    ++command.count;
    const std::uint8_t arm_count = command.board.arm_count;
    command.board = BoardCommand::drive(limited({5, 0, 0}), kColdOhm, 1.5e-3, {5, 0, 0}, 12.0);
    command.board.arm_count = arm_count;
  }
  void step() { frames = link.step(command); }
  void tick() {
    telemetry();
    renew();
    step();
    if (frames.other) take(*frames.other);
  }
  void take(const Frame& frame) {
    board::FrameHeader header;
    ASSERT_EQ(board::read_header(frame.data(), frame.size(), header), board::FrameError::kNone);
  }
  board::SetPointFrame set_point() const { return board::read_set_point(frames.set_point.data()); }
  std::optional<std::uint8_t> arm_request() const {
    if (!frames.other) return std::nullopt;
    board::FrameHeader header;
    board::read_header(frames.other->data(), frames.other->size(), header);
    if (header.type != board::FrameType::kArm) return std::nullopt;
    return board::read_arm(frames.other->data()).count;
  }
};

TEST_F(LinkBench, PassesAFreshSetPointOn) {
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

TEST_F(LinkBench, WithoutABoardOnlyTheSafeCommandGoesOut) {
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

TEST_F(LinkBench, CountsWhatWasLostAndWhatWasBroken) {
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

TEST_F(LinkBench, TelemetryThatComesTwiceIsNotNew) {
  tick();
  send(board);
  EXPECT_EQ(link.report().telemetry_count, 1u);
  EXPECT_EQ(link.report().counters.errors, 1u);
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

TEST_F(LinkBench, GoesOnFromTheNumberThatTheBoardHasHeardBefore) {
  board.received_sequence = 5'000'000;
  tick();
  EXPECT_EQ(set_point().sequence, 5'000'001u);
}

// -- arming -------------------------------------------------------------------------------------

TEST_F(LinkBench, AChangedArmCountIsRequestedUntilTheBoardConfirmsIt) {
  tick();
  command.board.arm_count = 1;
  for (int i = 0; i < 5; ++i) {
    tick();
    ASSERT_EQ(arm_request(), std::optional<std::uint8_t>(1));
    EXPECT_GT(board::read_arm(frames.other->data()).sequence, set_point().sequence);
  }
  board.arm_count = 1;
  tick();
  EXPECT_EQ(arm_request(), std::nullopt);
}

TEST_F(LinkBench, ItGivesUpAfterFiftyTicks) {
  tick();
  command.board.arm_count = 1;
  int requests = 0;
  for (int i = 0; i < 200; ++i) {
    tick();
    if (arm_request()) ++requests;
  }
  EXPECT_EQ(requests, 50);
}

TEST_F(LinkBench, ABoardThatAppearsLaterIsNotArmedByAnOldRequest) {
  command.board.arm_count = 1;
  renew();
  step();
  for (int i = 0; i < 200; ++i) {
    tick();
    ASSERT_EQ(arm_request(), std::nullopt);
  }
}

TEST_F(LinkBench, ARequestEndsWithTheBoardItWasMeantFor) {
  tick();
  command.board.arm_count = 1;
  tick();
  ASSERT_TRUE(arm_request());
  send_of_another_version();
  step();
  ASSERT_FALSE(link.report().present);
  tick();
  EXPECT_TRUE(link.report().present);
  EXPECT_EQ(arm_request(), std::nullopt);
}

TEST_F(LinkBench, ABoardThatRestartsIsNotArmedByAnOldRequest) {
  tick();
  command.board.arm_count = 1;
  tick();
  ASSERT_TRUE(arm_request());
  board.sequence = 0;
  board.board_ms = 0;
  tick();
  EXPECT_EQ(arm_request(), std::nullopt);
  EXPECT_EQ(link.report().counters.lost, 0u);
}

TEST_F(LinkBench, ABoardThatRestartsAfterTwentyFiveDaysIsSeenToHaveRestarted) {
  board.sequence = 0x8000'0100u;
  board.board_ms = 0x8000'0100u;
  tick();
  command.board.arm_count = 1;
  tick();
  ASSERT_TRUE(arm_request());
  board.sequence = 0;
  board.board_ms = 0;
  tick();
  EXPECT_EQ(arm_request(), std::nullopt);
  EXPECT_EQ(link.report().counters.lost, 0u);
  EXPECT_EQ(link.report().telemetry.sequence, 1u);
}

TEST_F(LinkBench, AClockThatComesRoundIsNoRestart) {
  board.sequence = 0xFFFF'FFF0u;
  board.board_ms = 0xFFFF'FFF0u;
  tick();
  command.board.arm_count = 1;
  for (int i = 0; i < 40; ++i) {
    tick();
    ASSERT_TRUE(arm_request()) << i;
  }
  EXPECT_EQ(link.report().counters.errors, 0u);
  EXPECT_EQ(link.report().counters.lost, 0u);
}

TEST_F(LinkBench, ARequestDiffersFromTheCountOfABoardThatHasRestarted) {
  board.arm_count = 255;
  tick();
  command.board.arm_count = 255;
  tick();
  board.sequence = 0;
  board.board_ms = 0;
  board.arm_count = 0;
  tick();
  EXPECT_EQ(arm_request(), std::nullopt);
  command.board.arm_count = 0;  // 255 + 1
  tick();
  ASSERT_EQ(arm_request(), std::optional<std::uint8_t>(1));
  board.arm_count = 1;
  tick();
  EXPECT_EQ(arm_request(), std::nullopt);
  EXPECT_EQ(link.report().telemetry.arm_count, 0) << "confirmed, as control counts";
}

TEST_F(LinkBench, TakingOverTheBoardsOwnCountIsNoRequest) {
  board.arm_count = 7;
  tick();
  command.board.arm_count = 7;
  tick();
  EXPECT_EQ(arm_request(), std::nullopt);
  command.board.arm_count = 8;
  tick();
  EXPECT_EQ(arm_request(), std::optional<std::uint8_t>(8));
}

// -- what rarely goes out -----------------------------------------------------------------------

TEST_F(LinkBench, LimitsGoToEveryBoardThatAppears) {
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

TEST_F(LinkBench, SimulatorSettingsGoOutWhenTheyChangeAndEveryHundredTicks) {
  SimulatorSettings settings;
  int sent = 0;
  for (int i = 0; i < 250; ++i) {
    telemetry();
    renew();
    if (i == 50) settings.faults = kSimFanStopped;
    frames = link.step(command, settings);
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
