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
class Nobody : public Transport {
 public:
  Nobody(bool idle, std::atomic<int>& looks) : idle_(idle), looks_(looks) {}
  bool send(std::span<const std::uint8_t, board::kFrameSize>) noexcept override { return false; }
  std::size_t receive(std::span<std::uint8_t>) noexcept override {
    ++looks_;
    return 0;
  }
  bool open() const noexcept override { return true; }
  bool idle() const noexcept override { return idle_; }

 private:
  bool idle_;
  std::atomic<int>& looks_;
};

// An idle link polls once in 10 ms and never catches up on missed polls: that bound is exact,
// however late it wakes.
TEST(LinkThreads, RestWhileNobodyIsThere) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kIdlePeriod{10};
  const Clock::time_point start = Clock::now();
  LinkPort busy_port;
  LinkPort idle_port;
  std::atomic<int> busy_looks{0};
  std::atomic<int> idle_looks{0};
  LinkThread busy(busy_port, std::make_unique<Nobody>(false, busy_looks));
  LinkThread idle(idle_port, std::make_unique<Nobody>(true, idle_looks));
  // Three times as often as the maximum of an idle link. A busy machine may delay it, but not in
  // every period.
  const auto looks_often = [&] {
    const Clock::time_point began = Clock::now();
    const int before = busy_looks;
    while (busy_looks < before + 10) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const int looks = busy_looks - before;
    return looks * kIdlePeriod > 3 * (Clock::now() - began);
  };
  bool often = looks_often();
  while (!often && Clock::now() < start + std::chrono::seconds(60)) often = looks_often();
  EXPECT_TRUE(often);
  while (idle_looks < 10) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const int looks = idle_looks;
  EXPECT_LE(looks * kIdlePeriod, Clock::now() - start);
}

/// A board that sends telemetry, behind a transport that takes 30 ms each time.
class Slow : public Transport {
 public:
  Slow(std::atomic<int>& sent, std::atomic<int>& driving) : sent_(sent), driving_(driving) {}
  bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept override {
    ++sent_;
    if (board::read_set_point(frame.data()).enable) ++driving_;
    return true;
  }
  std::size_t receive(std::span<std::uint8_t> packet) noexcept override {
    told_ = !told_;
    if (!told_) return 0;
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
  bool told_ = false;
};

TEST(LinkThreads, CountMillisecondsAndNotTheirOwnSteps) {
  std::atomic<int> sent{0};
  std::atomic<int> driving{0};
  LinkPort port;
  LinkCommand command;
  command.count = 1;
  command.board = BoardCommand::drive(limited({5, 0, 0}), kColdOhm, 1.5e-3, {5, 0, 0}, 12.0);
  port.commands.write(command);
  {
    LinkThread link(port, std::make_unique<Slow>(sent, driving));
    while (sent < 5) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(driving, 1) << "the second came more than 20 ms after the only one that control gave";
}

}  // namespace
}  // namespace hedgehog::device
