// SPDX-License-Identifier: MIT
// How often the link thread polls, and how it counts time when it cannot poll as often as it
// should. No test asserts how soon a thread runs; a slower machine changes nothing.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "daemon/device/link_thread.h"
#include "tests/device/limited.h"

namespace hedgehog::device {
namespace {

/// A transport without a board, idle or not; counts the polls.
class SilentTransport : public Transport {
 public:
  SilentTransport(bool idle, std::atomic<int>& polls) : idle_(idle), polls_(polls) {}
  bool send(std::span<const std::uint8_t, board::kFrameSize>) noexcept override { return false; }
  std::size_t receive(std::span<std::uint8_t>) noexcept override {
    ++polls_;
    return 0;
  }
  bool open() const noexcept override { return true; }
  bool idle() const noexcept override { return idle_; }

 private:
  bool idle_;
  std::atomic<int>& polls_;
};

// An idle link polls once in 10 ms and never catches up on missed polls: that bound is exact,
// however late it wakes.
TEST(LinkThreads, PollSlowlyWithoutABoard) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kIdlePeriod{10};
  const Clock::time_point start = Clock::now();
  LinkPort busy_port;
  LinkPort idle_port;
  std::atomic<int> busy_polls{0};
  std::atomic<int> idle_polls{0};
  LinkThread busy(busy_port, std::make_unique<SilentTransport>(false, busy_polls));
  LinkThread idle(idle_port, std::make_unique<SilentTransport>(true, idle_polls));
  // Three times as often as the maximum of an idle link. A busy machine may delay it, but not in
  // every period.
  const auto polls_often = [&] {
    const Clock::time_point began = Clock::now();
    const int before = busy_polls;
    while (busy_polls < before + 10) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const int polls = busy_polls - before;
    return polls * kIdlePeriod > 3 * (Clock::now() - began);
  };
  bool often = polls_often();
  while (!often && Clock::now() < start + std::chrono::seconds(60)) often = polls_often();
  EXPECT_TRUE(often);
  while (idle_polls < 10) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const int polls = idle_polls;
  EXPECT_LE(polls * kIdlePeriod, Clock::now() - start);
}

/// A board that sends telemetry, behind a transport that takes 30 ms each time.
class SlowTransport : public Transport {
 public:
  SlowTransport(std::atomic<int>& sent, std::atomic<int>& driving)
      : sent_(sent), driving_(driving) {}
  bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept override {
    ++sent_;
    if (board::read_set_point(frame.data()).enable) ++driving_;
    return true;
  }
  std::size_t receive(std::span<std::uint8_t> packet) noexcept override {
    delivered_ = !delivered_;
    if (!delivered_) return 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    ++board_.sequence;
    board::write_frame(board_, packet.data());
    return board::kFrameSize;
  }
  bool open() const noexcept override { return true; }

 private:
  std::atomic<int>& sent_;
  std::atomic<int>& driving_;
  board::TelemetryFrame board_;
  bool delivered_ = false;
};

TEST(LinkThreads, CountMillisecondsAndNotTheirSteps) {
  std::atomic<int> sent{0};
  std::atomic<int> driving{0};
  LinkPort port;
  LinkCommand command;
  command.count = 1;
  command.board = BoardCommand::drive(limited({5, 0, 0}), kColdOhm, 1.5e-3, {5, 0, 0}, 12.0);
  port.commands.write(command);
  {
    LinkThread link(port, std::make_unique<SlowTransport>(sent, driving));
    while (sent < 5) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(driving, 1) << "the second came more than 20 ms after the only one that control gave";
}

}  // namespace
}  // namespace hedgehog::device
