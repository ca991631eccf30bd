// SPDX-License-Identifier: MIT
// How the link requests a board to arm, and detects a board that has restarted.

#include "tests/device/link_bench.h"

namespace hedgehog::device {
namespace {

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

TEST_F(LinkBench, ARequestTimesOutAfterFiftyTicks) {
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

TEST_F(LinkBench, ARequestEndsWhenItsBoardDisconnects) {
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

TEST_F(LinkBench, ARestartAfterTwentyFiveDaysIsDetected) {
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

TEST_F(LinkBench, AClockThatWrapsIsNoRestart) {
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

TEST_F(LinkBench, AdoptingTheBoardsOwnCountIsNoRequest) {
  board.arm_count = 7;
  tick();
  command.board.arm_count = 7;
  tick();
  EXPECT_EQ(arm_request(), std::nullopt);
  command.board.arm_count = 8;
  tick();
  EXPECT_EQ(arm_request(), std::optional<std::uint8_t>(8));
}

// -- frames that are sent rarely ----------------------------------------------------------------

}  // namespace
}  // namespace hedgehog::device
