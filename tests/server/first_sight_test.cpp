// SPDX-License-Identifier: MIT
// How long a starting daemon keeps its doors shut.
#include "daemon/first_sight.h"

#include <gtest/gtest.h>

namespace hedgehog::daemon {
namespace {

using std::chrono::milliseconds;

TEST(FirstSight, IsHalfASecondOfTheClockAndOfControl) {
  const FirstSight::Clock::time_point begun{};
  const FirstSight sight(begun);
  EXPECT_FALSE(sight.over(begun + milliseconds(400), 600)) << "a ball that runs faster than time";
  EXPECT_FALSE(sight.over(begun + milliseconds(600), 400)) << "a machine that was busy";
  EXPECT_TRUE(sight.over(begun + milliseconds(501), 501));
  EXPECT_FALSE(sight.over(begun + milliseconds(5000), 0));
  EXPECT_TRUE(sight.over(begun + milliseconds(5001), 0)) << "whatever is wrong, it can be asked";
}

}  // namespace
}  // namespace hedgehog::daemon
