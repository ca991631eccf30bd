// SPDX-License-Identifier: MIT
// How long a starting daemon does not accept clients.
#include "daemon/startup_grace.h"

#include <gtest/gtest.h>

namespace hedgehog::daemon {
namespace {

using std::chrono::milliseconds;

TEST(StartupGrace, IsHalfASecondOfTheClockAndOfControlTicks) {
  const StartupGrace::Clock::time_point begun{};
  const StartupGrace usb_info(begun);
  EXPECT_FALSE(usb_info.over(begun + milliseconds(400), 600))
      << "a ball that runs faster than time";
  EXPECT_FALSE(usb_info.over(begun + milliseconds(600), 400)) << "a machine that was busy";
  EXPECT_TRUE(usb_info.over(begun + milliseconds(501), 501));
  EXPECT_FALSE(usb_info.over(begun + milliseconds(5000), 0));
  EXPECT_TRUE(usb_info.over(begun + milliseconds(5001), 0)) << "whatever is wrong, it can be asked";
}

}  // namespace
}  // namespace hedgehog::daemon
