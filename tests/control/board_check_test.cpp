// SPDX-License-Identifier: MIT
// The daemon's checks of a board's own limits, its silence and its faults.
#include "daemon/control/checks/board_check.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

#include "daemon/device/board_codec.h"

namespace hedgehog::control {
namespace {

// A board with the expected limits plus these offsets.
device::BoardTelemetry board_with(double more_a, double more_k) {
  const auto configured = device::BoardLimits::of(model::Limits{});
  device::BoardTelemetry board;
  board.limit_current_a = configured.current_a + more_a;
  board.limit_sensor_c = configured.sensor_c + more_k;
  return board;
}

TEST(BoardCheck, ABoardThatAllowsAsMuchOrMoreLeavesTheLimits) {
  for (const double more : {-0.01, 0.0, 5.0})
    EXPECT_EQ(limits_within(model::Limits{}, board_with(more, more)), model::Limits{}) << more;
}

TEST(BoardCheck, ABoardThatAllowsLessCurrentScalesTheLimits) {
  const model::Limits configured;
  const double boards_a = device::BoardLimits::of(configured).current_a;
  model::Limits within = limits_within(configured, board_with(-boards_a / 2, 0.0));
  EXPECT_NEAR(within.current_a, configured.current_a / 2, 1e-12);
  EXPECT_EQ(within.continuous_a, configured.continuous_a) << "less than half of the peak";
  EXPECT_EQ(within.zero_c, configured.zero_c);
  within = limits_within(configured, board_with(-boards_a * 0.9, 0.0));
  EXPECT_NEAR(within.current_a, configured.current_a / 10, 1e-12);
  EXPECT_EQ(within.continuous_a, within.current_a);
  EXPECT_LE(within.felt_a, within.current_a);
  model::Limits with_felt_limit = configured;
  with_felt_limit.felt_a = configured.current_a;
  EXPECT_NEAR(limits_within(with_felt_limit, board_with(-boards_a / 2, 0.0)).felt_a,
              configured.current_a / 2, 1e-12);
  within = limits_within(configured, board_with(-0.011, 0.0));
  EXPECT_LT(within.current_a, configured.current_a);
  EXPECT_EQ(limits_within(configured, board_with(-boards_a - 1.0, 0.0)).current_a, 0.0);
}

TEST(BoardCheck, ABoardThatTripsCoolerShiftsTheTemperatures) {
  const model::Limits configured;
  model::Limits shifted = configured;
  shifted.derate_from_c -= 5.0;
  shifted.sustain_c -= 5.0;
  shifted.zero_c -= 5.0;
  shifted.trip_c -= 5.0;
  EXPECT_EQ(limits_within(configured, board_with(0.0, -5.0)), shifted);
  EXPECT_LT(limits_within(configured, board_with(0.0, -0.011)).zero_c, configured.zero_c);
}

TEST(BoardCheck, SilenceIncludesSkippedTicks) {
  BoardCheck check;
  check.step(true, true, {}, 1);
  EXPECT_EQ(check.age(), 0u);
  check.step(true, false, {}, 99);
  EXPECT_TRUE(check.alive());
  EXPECT_EQ(check.age(), 99u);
  check.step(true, false, {}, 1);
  EXPECT_FALSE(check.alive());
}

TEST(BoardCheck, FiftyTicksWithoutBeingArmedIsARestart) {
  BoardCheck check;
  device::BoardTelemetry board;
  board.mode = device::BoardMode::kSafe;
  check.step(true, true, board, 49);
  EXPECT_FALSE(check.restarted());
  check.step(true, true, board, 1);
  EXPECT_TRUE(check.restarted());
  for (const auto armed : {device::BoardMode::kReady, device::BoardMode::kDriving}) {
    board.mode = armed;
    check.step(true, true, board, 1);
    EXPECT_FALSE(check.restarted());
    board.mode = device::BoardMode::kLatched;
    check.step(true, true, board, 49);
    EXPECT_FALSE(check.restarted());
    check.step(true, false, board, 1);
    EXPECT_FALSE(check.restarted()) << "nothing new was heard";
    check.step(true, true, board, 1);
    EXPECT_TRUE(check.restarted());
  }
}

TEST(BoardCheck, NamesTheMostSevereFault) {
  const std::pair<std::uint16_t, Reason> most_severe_first[] = {
      {board::kStuckBridge, Reason::kBoardStuckBridge},
      {board::kBridge, Reason::kBridgeFault},
      {board::kUnexpectedCurrent, Reason::kUnexpectedCurrent},
      {board::kCurrentSense, Reason::kCurrentMismatch},
      {board::kOverCurrent, Reason::kBoardOverCurrent},
      {board::kOverHeat, Reason::kBoardOverHeat},
      {board::kHeatBudget, Reason::kBoardHeatBudget},
      {board::kSupply, Reason::kBoardSupply},
      {board::kSensorOpen, Reason::kSensorOpen},
      {board::kSensorShort, Reason::kSensorShort},
      {board::kDeadMan, Reason::kBoardDeadMan},
  };
  EXPECT_EQ(reason_of_faults(0), Reason::kNone);
  std::uint16_t rest = 0;
  for (const auto& [fault, reason] : most_severe_first) rest |= fault;
  for (const auto& [fault, reason] : most_severe_first) {
    EXPECT_EQ(reason_of_faults(fault), reason) << name(reason);
    EXPECT_EQ(reason_of_faults(rest), reason) << name(reason) << " with all that are less severe";
    rest = static_cast<std::uint16_t>(rest & ~fault);
  }
}

TEST(BoardCheck, ClearsAFaultThatIsNoLongerReported) {
  BoardCheck check;
  device::BoardTelemetry board;
  board.faults = board::kSupply;
  check.step(true, true, board, 1);
  EXPECT_EQ(check.fault(), Reason::kBoardSupply);
  check.step(true, false, device::BoardTelemetry{}, 1);
  EXPECT_EQ(check.fault(), Reason::kBoardSupply) << "as of its last frame";
  check.step(true, true, device::BoardTelemetry{}, 1);
  EXPECT_EQ(check.fault(), Reason::kNone);
}

}  // namespace
}  // namespace hedgehog::control
