// SPDX-License-Identifier: MIT
// An unattended run waits for a ball, but not for ever.
#include "clients/study/session/waiting_time.h"

#include <gtest/gtest.h>

namespace hedgehog::study {
namespace {

using namespace std::chrono_literals;

constexpr WaitingTime::Clock::time_point kBegin{};
constexpr std::int64_t kMinuteNs = 60'000'000'000;

TEST(WaitingTime, IsTwoMinutesByTheClock) {
  const WaitingTime waited(kBegin);
  EXPECT_FALSE(waited.is_over(kBegin + 120s));
  EXPECT_TRUE(waited.is_over(kBegin + 121s));
}

TEST(WaitingTime, ForABallThatCoolsIsHalfAnHourOfItsTime) {
  WaitingTime slow(kBegin);
  for (int i = 0; i <= 30; ++i)
    EXPECT_FALSE(slow.is_over_cooling(kBegin + i * 100s, (7 + i) * kMinuteNs)) << i;
  EXPECT_TRUE(slow.is_over_cooling(kBegin + 3100s, 38 * kMinuteNs));
  WaitingTime quick(kBegin);
  EXPECT_FALSE(quick.is_over_cooling(kBegin, kMinuteNs));
  EXPECT_TRUE(quick.is_over_cooling(kBegin + 1s, 32 * kMinuteNs));
}

TEST(WaitingTime, IsOverWhenTheBallsTimeStandsStill) {
  WaitingTime waited(kBegin);
  EXPECT_FALSE(waited.is_over_cooling(kBegin + 100s, kMinuteNs));
  EXPECT_FALSE(waited.is_over_cooling(kBegin + 220s, kMinuteNs));
  EXPECT_TRUE(waited.is_over_cooling(kBegin + 221s, kMinuteNs));
}

TEST(WaitingTime, ABallThatNoLongerCoolsHasTwoMinutes) {
  WaitingTime waited(kBegin);
  EXPECT_FALSE(waited.is_over_cooling(kBegin + 100s, kMinuteNs));
  EXPECT_FALSE(waited.is_over(kBegin + 220s));
  EXPECT_TRUE(waited.is_over(kBegin + 221s));
}

TEST(WaitingTime, ARestartedDaemonsBallIsWaitedForFromItsStart) {
  WaitingTime waited(kBegin);
  EXPECT_FALSE(waited.is_over_cooling(kBegin, 100 * kMinuteNs));
  EXPECT_FALSE(waited.is_over_cooling(kBegin + 1s, kMinuteNs));
  EXPECT_FALSE(waited.is_over_cooling(kBegin + 2s, 31 * kMinuteNs));
  EXPECT_TRUE(waited.is_over_cooling(kBegin + 3s, 32 * kMinuteNs));
}

}  // namespace
}  // namespace hedgehog::study
