// SPDX-License-Identifier: MIT
// Receives and sends through io_uring, on socket pairs. Skipped where the kernel forbids it.
#include "daemon/server/net/line/ring.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace hedgehog::server {
namespace {

class SocketPair {
 public:
  SocketPair() { EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()), 0); }
  SocketPair(const SocketPair&) = delete;
  SocketPair& operator=(const SocketPair&) = delete;
  ~SocketPair() {
    for (const int end : ends_) ::close(end);
  }
  int ours() const { return ends_[0]; }
  void write(std::string_view bytes) const {
    EXPECT_EQ(::send(ends_[1], bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
  }
  /// What the other end has received so far.
  std::string read() const {
    std::string all;
    std::array<char, 4096> part;
    ssize_t count = 0;
    while ((count = ::recv(ends_[1], part.data(), part.size(), MSG_DONTWAIT)) > 0)
      all.append(part.data(), static_cast<std::size_t>(count));
    return all;
  }
  void half_close() const { ::shutdown(ends_[1], SHUT_WR); }

 private:
  std::array<int, 2> ends_{};
};

/// Remembers how it has ended.
struct Recorded final : Ring::Operation {
  int result = 0;
  std::string received;
  int completions = 0;
  int drops = 0;
  std::function<void()> then = [] {};

 private:
  void complete(int count, std::string_view data) override {
    result = count;
    received += data;
    ++completions;
    then();
  }
  void drop() noexcept override { ++drops; }
};

class RingTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string reason;
    ring = Ring::open(io, reason);
    if (!ring) GTEST_SKIP() << reason;
  }
  /// Runs the io thread until `done`.
  template <class Done>
  void run_until(Done done) {
    while (!done()) ASSERT_GT(io.run_one_for(std::chrono::seconds(60)), 0u);
  }
  void run_until_complete(const Recorded& operation, int completions = 1) {
    run_until([&] { return operation.completions >= completions; });
  }

  boost::asio::io_context io{1};
  std::unique_ptr<Ring> ring;
};

TEST_F(RingTest, ReceivesWhatCameBeforeAndWhatComesLater) {
  const SocketPair sockets;
  sockets.write("before");
  Recorded receive;
  receive.then = [&] {
    if (receive.completions == 1) ring->receive(sockets.ours(), receive);
  };
  ring->receive(sockets.ours(), receive);
  run_until_complete(receive);
  EXPECT_EQ(receive.received, "before");
  EXPECT_TRUE(receive.is_pending());
  while (io.poll() > 0) {
  }
  sockets.write(" and later");
  run_until_complete(receive, 2);
  EXPECT_EQ(receive.received, "before and later");
  EXPECT_FALSE(receive.is_pending());
}

TEST_F(RingTest, ReceivesLongDataInParts) {
  const SocketPair sockets;
  const std::string all(3 * Ring::kReceiveBytes + 1, 'x');
  sockets.write(all);
  Recorded receive;
  receive.then = [&] { ring->receive(sockets.ours(), receive); };
  ring->receive(sockets.ours(), receive);
  run_until([&] { return receive.received.size() == all.size(); });
  EXPECT_EQ(receive.completions, 4);
  ring.reset();
}

TEST_F(RingTest, TheEndOfTheStreamIsZeroBytes) {
  const SocketPair sockets;
  Recorded receive;
  ring->receive(sockets.ours(), receive);
  while (io.poll() > 0) {
  }
  ASSERT_TRUE(receive.is_pending());
  sockets.half_close();
  run_until_complete(receive);
  EXPECT_EQ(receive.result, 0);
}

TEST_F(RingTest, AShutdownEndsAReceive) {
  const SocketPair sockets;
  Recorded receive;
  ring->receive(sockets.ours(), receive);
  while (io.poll() > 0) {
  }
  ::shutdown(sockets.ours(), SHUT_RDWR);
  run_until_complete(receive);
  EXPECT_LE(receive.result, 0);
}

TEST_F(RingTest, MoreSocketsAtATimeThanBuffersLoseNothing) {
  std::vector<std::unique_ptr<SocketPair>> sockets;
  std::deque<Recorded> receives;
  int completed = 0;
  for (int i = 0; i < 300; ++i) {
    sockets.push_back(std::make_unique<SocketPair>());
    ring->receive(sockets.back()->ours(), receives.emplace_back());
    receives.back().then = [&] { ++completed; };
  }
  while (io.poll() > 0) {
  }
  for (std::size_t i = 0; i < sockets.size(); ++i) sockets[i]->write(std::to_string(i));
  run_until([&] { return completed == 300; });
  for (std::size_t i = 0; i < sockets.size(); ++i)
    EXPECT_EQ(receives[i].received, std::to_string(i));
}

TEST_F(RingTest, SendsInTheOrderOfTheirStartAlsoMoreThanThereAreEntries) {
  constexpr int kSends = 2500;
  const std::array<SocketPair, 50> sockets;
  std::array<std::string, 50> expected;
  std::deque<std::string> texts;
  std::deque<Recorded> sends;
  int completed = 0;
  for (std::size_t i = 0; i < kSends; ++i) {
    texts.push_back(std::to_string(i));
    expected[i % 50] += texts.back();
    ring->send_now(sockets[i % 50].ours(), texts.back(), sends.emplace_back());
    sends.back().then = [&] { ++completed; };
  }
  run_until([&] { return completed == kSends; });
  for (std::size_t i = 0; i < sockets.size(); ++i) EXPECT_EQ(sockets[i].read(), expected[i]);
}

TEST_F(RingTest, WhatASocketDoesNotTakeAtOnceIsReportedOrWaits) {
  const SocketPair sockets;
  const std::string much(std::size_t{1} << 24, 'x');
  Recorded first;
  ring->send_now(sockets.ours(), much, first);
  run_until_complete(first);
  ASSERT_GT(first.result, 0);
  ASSERT_LT(first.result, 1 << 24);

  Recorded none;
  ring->send_now(sockets.ours(), "y", none);
  run_until_complete(none);
  EXPECT_EQ(none.result, -EAGAIN);

  Recorded waits;
  ring->send(sockets.ours(), "z", waits);
  while (io.poll() > 0) {
  }
  EXPECT_TRUE(waits.is_pending());
  std::string read = sockets.read();
  run_until_complete(waits);
  EXPECT_EQ(waits.result, 1);
  read += sockets.read();
  EXPECT_EQ(read, std::string(static_cast<std::size_t>(first.result), 'x') + "z");
}

TEST_F(RingTest, AClosedPeerIsAnErrorAndNoSignal) {
  auto sockets = std::make_unique<SocketPair>();
  const int ours = ::dup(sockets->ours());
  sockets.reset();
  Recorded send;
  ring->send_now(ours, "x", send);
  run_until_complete(send);
  EXPECT_EQ(send.result, -EPIPE);
  ::close(ours);
}

TEST_F(RingTest, WhatIsWithdrawnIsNotSent) {
  const SocketPair sockets;
  Recorded withdrawn;
  Recorded next;
  ring->send_now(sockets.ours(), "no", withdrawn);
  EXPECT_TRUE(ring->withdraw(withdrawn));
  EXPECT_FALSE(withdrawn.is_pending());
  ring->send_now(sockets.ours(), "yes", next);
  run_until_complete(next);
  EXPECT_EQ(sockets.read(), "yes");
  EXPECT_EQ(withdrawn.completions, 0);
}

TEST_F(RingTest, WhatTheKernelHasIsNotWithdrawn) {
  const SocketPair sockets;
  Recorded receive;
  ring->receive(sockets.ours(), receive);
  while (io.poll() > 0) {
  }
  EXPECT_FALSE(ring->withdraw(receive));
  EXPECT_FALSE(ring->settle(receive));
  EXPECT_TRUE(receive.is_pending());
  ring.reset();
}

TEST_F(RingTest, WhatTheKernelHasSentIsSettledBeforeItsTurn) {
  const SocketPair sockets;
  Recorded first;
  Recorded second;
  bool settled = false;
  first.then = [&] { settled = ring->settle(second); };
  ring->send_now(sockets.ours(), "1", first);
  ring->send_now(sockets.ours(), "2", second);
  run_until_complete(first);
  EXPECT_TRUE(settled);
  EXPECT_EQ(second.result, 1);
  while (io.poll() > 0) {
  }
  EXPECT_EQ(second.completions, 1);
  EXPECT_EQ(sockets.read(), "12");
}

TEST_F(RingTest, ADestroyedRingDropsWhatIsPending) {
  const SocketPair sockets;
  Recorded receive;
  Recorded send;
  ring->receive(sockets.ours(), receive);
  while (io.poll() > 0) {
  }
  ring->send_now(sockets.ours(), "never", send);
  ring.reset();
  EXPECT_EQ(receive.drops, 1);
  EXPECT_EQ(send.drops, 1);
  EXPECT_EQ(receive.completions + send.completions, 0);
  EXPECT_EQ(sockets.read(), "");
}

TEST(RingOpen, SaysWhyTheKernelRefuses) {
  boost::asio::io_context io{1};
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const int next = ::dup(0);
  ASSERT_GE(next, 0);
  ::close(next);
  const rlimit none{static_cast<rlim_t>(next), before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  std::string reason;
  EXPECT_EQ(Ring::open(io, reason), nullptr);
  EXPECT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_NE(reason, "");
}

}  // namespace
}  // namespace hedgehog::server
