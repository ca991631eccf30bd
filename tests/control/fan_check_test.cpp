// SPDX-License-Identifier: MIT
// The fan counts as cooling only with fresh telemetry, while driven, and at a plausible speed.
#include "daemon/control/checks/fan_check.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "model/tick.h"

namespace hedgehog::control {
namespace {

using model::kTickSeconds;

FanCheck after(double seconds, const FanReading& reading, FanCheck check = FanCheck(7200.0)) {
  for (double t = 0.0; t < seconds; t += kTickSeconds) check.follow(reading, kTickSeconds);
  return check;
}

TEST(FanCooling, IsCreditedAtFullDutyAndASpeedThatItCanHave) {
  EXPECT_TRUE(after(1.0, {true, 1.0, 7200.0}).cooling());
  EXPECT_TRUE(after(1.0, {true, 1.0, 10'700.0}).cooling());
  EXPECT_FALSE(after(1.0, {true, 1.0, 10'900.0}).cooling());
  EXPECT_TRUE(after(1.0, {true, 1.0, 5100.0}).cooling());
  EXPECT_FALSE(after(1.0, {true, 1.0, 5000.0}).cooling()) << "half as fast cools less";
  EXPECT_FALSE(after(1.0, {true, 0.0, 7200.0}).cooling()) << "nothing drives it";
  EXPECT_FALSE(after(1.0, {true, 1.0, std::nan("")}).cooling());
  EXPECT_TRUE(after(1.0, {true, 1.0, 3000.0}, FanCheck(3000.0)).cooling());
}

TEST(FanCooling, NeedsHalfASecondAndEndsAtOnce) {
  EXPECT_FALSE(after(0.49, {true, 1.0, 7200.0}).cooling());
  FanCheck check = after(0.51, {true, 1.0, 7200.0});
  EXPECT_TRUE(check.cooling());
  check.follow({true, 1.0, 20'000.0}, kTickSeconds);
  EXPECT_FALSE(check.cooling());
}

TEST(FanCooling, EndsWithTheTelemetry) {
  const FanCheck check = after(1.0, {true, 1.0, 7200.0});
  EXPECT_TRUE(after(0.09, {false, 1.0, 7200.0}, check).cooling()) << "single frames are lost";
  EXPECT_FALSE(after(0.11, {false, 1.0, 7200.0}, check).cooling());
  EXPECT_FALSE(after(0.4, {true, 1.0, 7200.0}, after(0.2, {}, check)).cooling());
}

TEST(FanCooling, ATelemetryOfATenthOfASecondIsNotTooOld) {
  FanCheck check = after(1.0, {true, 1.0, 7200.0});
  for (int half = 0; half < 2; ++half) check.follow({}, FanCheck::kMaxAgeS / 2);
  EXPECT_TRUE(check.cooling());
  check.follow({}, kTickSeconds);
  EXPECT_FALSE(check.cooling());
}

TEST(FanCooling, ADrivenFanThatIsTooSlowIsDefective) {
  EXPECT_TRUE(after(60.0, {true, 0.0, 0.0}).works());
  EXPECT_TRUE(after(9.0, {true, 1.0, 2000.0}).works()) << "it may take its time to start";
  const FanCheck slow = after(11.0, {true, 1.0, 2000.0});
  EXPECT_FALSE(slow.works());
  EXPECT_FALSE(after(60.0, {true, 0.0, 0.0}, slow).works()) << "until it is seen to work";
  EXPECT_TRUE(after(1.0, {true, 1.0, 7200.0}, slow).works());
}

TEST(FanCooling, TheTimeToStartBeginsAnewOnceItHasTurned) {
  const FanReading slow{true, 1.0, 2000.0};
  const FanCheck turned = after(0.1, {true, 1.0, 7200.0}, after(9.5, slow));
  EXPECT_TRUE(after(9.5, slow, turned).works());
  EXPECT_FALSE(after(10.5, slow, turned).works());
}

TEST(FanCooling, AResetClearsTheFaultOfAStoppedFan) {
  FanCheck check;
  Reason found = Reason::kNone;
  for (double t = 0.0; t < 3.1; t += kTickSeconds) found = check.step(true, 0.0, kTickSeconds);
  EXPECT_EQ(name(found), "fan_stopped");
  EXPECT_TRUE(check.stopped());
  check.reset();
  EXPECT_FALSE(check.stopped());
  EXPECT_FALSE(check.stalled());
  EXPECT_EQ(name(check.step(true, 0.0, kTickSeconds)), "none");
}

RC_GTEST_PROP(FanCooling, IsNeverCreditedOutsideItsRange, ()) {
  FanCheck check(7200.0);
  for (int i = 0; i < 2000; ++i) {
    FanReading reading;
    reading.fresh = *rc::gen::weightedElement<bool>({{9, true}, {1, false}});
    reading.duty = *rc::gen::element(0.0, 1.0, 1.0, 1.0);
    reading.rpm = *rc::gen::element(0.0, 4000.0, 7200.0, 7200.0, 7200.0, 65'535.0);
    check.follow(reading, 0.02);
    const bool can = reading.duty == 1.0 && reading.rpm == 7200.0;
    if (reading.fresh && !can) RC_ASSERT(!check.cooling());
  }
}

}  // namespace
}  // namespace hedgehog::control
