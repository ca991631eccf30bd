// SPDX-License-Identifier: MIT
// A simulated board computed in its host's thread, on a clock set by the test.
#include "daemon/device/simulator/simulated_board_transport.h"

#include <gtest/gtest.h>

#include "daemon/device/link.h"
#include "tests/device/limited.h"

namespace hedgehog::device {
namespace {

constexpr std::int64_t kMs = 1'000'000;

std::int64_t board_clock_ns = kLinkPhaseNs;  // at a tick of the link

class SimulatedBoardWithinTheHost : public testing::Test {
 protected:
  SimulatedBoardWithinTheHost() { read_after(kMs); }

  /// The host sleeps for `ns`, then reads all packets. Returns the number of telemetry packets.
  int read_after(std::int64_t ns) {
    board_clock_ns += ns;
    int telemetry = 0;
    while (transport_.receive(packet_) != 0) {
      board::FrameHeader header;
      EXPECT_EQ(board::read_header(packet_.data(), packet_.size(), header),
                board::FrameError::kNone);
      telemetry += header.type == board::FrameType::kTelemetry ? 1 : 0;
      link_.receive(packet_);
    }
    return telemetry;
  }

  void send(const LinkCommand& command) {
    const LinkFrames frames = link_.step(command);
    transport_.send(frames.set_point);
    if (frames.other) transport_.send(*frames.other);
  }

  /// Arms and drives, a set-point a millisecond, until current flows.
  void drive() {
    LinkCommand command;
    for (int ms = 0; ms < 200; ++ms) {
      command.board = BoardCommand::drive(limited({5, 0, 0}), kColdOhm, 1.5e-3, {5, 0, 0}, 12.0);
      command.board.arm_count = link_.report().present ? 1 : 0;
      ++command.count;
      send(command);
      read_after(kMs);
    }
    ASSERT_GT(transport_.board().plant().current_a().x, 4.0);
  }

  Link link_;
  Frame packet_{};
  SimulatedBoardTransport transport_{SimulatedBoardOptions{},
                                     []() noexcept { return board_clock_ns; }};
};

TEST_F(SimulatedBoardWithinTheHost, SimulatesAMillisecondPerMillisecond) {
  for (int i = 0; i < 100; ++i) EXPECT_EQ(read_after(kMs), 1);
  EXPECT_EQ(read_after(0), 0);
}

TEST_F(SimulatedBoardWithinTheHost, SimulatesOneMillisecondForAHostThatIsSlightlyEarlyOrLate) {
  constexpr std::int64_t kJitter = 400'000;
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(read_after(kMs + kJitter), 1);
    EXPECT_EQ(read_after(kMs - kJitter), 1);
  }
}

TEST_F(SimulatedBoardWithinTheHost, CatchesUpAFewMillisecondsAndSkipsTheRest) {
  EXPECT_EQ(read_after(3 * kMs), 3);
  EXPECT_EQ(read_after(1000 * kMs), TickClock::kCatchUp + 1);
  EXPECT_EQ(read_after(kMs), 1);
}

TEST_F(SimulatedBoardWithinTheHost, DrivesWhenCommanded) { drive(); }

TEST_F(SimulatedBoardWithinTheHost, HasNoCurrentAfterTheDeadManOfAHostThatOnlyReads) {
  drive();
  constexpr int kDeadManMs = 101;
  constexpr int kDecayMs = 17;
  for (int ms = 0; ms < kDeadManMs + kDecayMs; ++ms) read_after(kMs);
  EXPECT_EQ(transport_.board().core().mode(), board::Mode::kLatched);
  EXPECT_LT(norm(transport_.board().plant().current_a()), 0.1);
}

}  // namespace
}  // namespace hedgehog::device
