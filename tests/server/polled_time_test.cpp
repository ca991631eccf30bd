// SPDX-License-Identifier: MIT
// The timeout of control or the disk, on a machine that delays the whole process.
#include "daemon/server/session/polled_time.h"

#include <gtest/gtest.h>

namespace hedgehog::server {
namespace {

using namespace std::chrono_literals;

TEST(PolledTime, IsTheClockIfPolledOften) {
  PolledTime::Clock::time_point now{};
  PolledTime waited(now);
  for (int i = 0; i < 400; ++i) waited.poll(now += 5ms);
  EXPECT_EQ(waited.elapsed(), 2s);
  waited.restart(now);
  EXPECT_EQ(waited.elapsed(), 0s);
  waited.poll(now += 1ms);
  EXPECT_EQ(waited.elapsed(), 1ms);
}

TEST(PolledTime, ExcludesTheTimeOfASuspendedProcess) {
  PolledTime::Clock::time_point now{};
  PolledTime waited(now);
  waited.poll(now += 1h);
  EXPECT_EQ(waited.elapsed(), PolledTime::kMaxStep);
  for (int i = 0; i < 10; ++i) waited.poll(now += 20ms);
  EXPECT_EQ(waited.elapsed(), PolledTime::kMaxStep + 200ms);
}

}  // namespace
}  // namespace hedgehog::server
