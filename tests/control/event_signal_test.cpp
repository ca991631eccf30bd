// SPDX-License-Identifier: MIT
#include "daemon/control/event_signal.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <boost/lockfree/spsc_queue.hpp>
#include <thread>

namespace hedgehog::control {
namespace {

/// Waits up to `timeout_ms` until the signal is raised.
bool raised(const EventSignal& signal, int timeout_ms = 0) {
  pollfd poll{signal.descriptor(), POLLIN, 0};
  return ::poll(&poll, 1, timeout_ms) == 1;
}

TEST(EventSignal, IsReadableFromARaiseUntilItIsTaken) {
  EventSignal signal;
  EXPECT_FALSE(raised(signal));
  signal.raise();
  signal.raise();
  EXPECT_TRUE(raised(signal));
  signal.take();
  EXPECT_FALSE(raised(signal));
  signal.take();
  signal.raise();
  EXPECT_TRUE(raised(signal));
}

// A reader that only waits for the signal gets everything, whatever the order of the two threads.
TEST(EventSignal, NothingStaysUnread) {
  constexpr int kEvents = 200'000;
  constexpr int kTimeoutMs = 20'000;
  EventSignal signal;
  boost::lockfree::spsc_queue<int, boost::lockfree::capacity<1024>> events;
  std::thread control([&] {
    for (int i = 1; i <= kEvents; ++i) {
      while (!events.push(i)) std::this_thread::yield();
      signal.raise();
    }
  });
  int last = 0;
  bool waits = true;
  while (last < kEvents && (waits = raised(signal, kTimeoutMs))) {
    signal.take();
    events.consume_all([&](int event) { last = event; });
  }
  EXPECT_TRUE(waits) << "no signal for what is unread";
  // If it failed, so that the other thread ends.
  while (last < kEvents) events.consume_all([&](int event) { last = event; });
  control.join();
}

}  // namespace
}  // namespace hedgehog::control
