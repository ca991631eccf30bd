// SPDX-License-Identifier: MIT
// Repeated arming after the same trip takes longer each time.
#include "daemon/control/state/rearm_backoff.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace hedgehog::control {
namespace {

using model::kTicksPerSecond;
using model::Tick;

constexpr Reason kReason = Reason::kSensorFrozen;

/// The state after `times` armings after as many trips for kReason, the last one at tick 0.
RearmBackoff after(int times) {
  RearmBackoff backoff;
  for (int i = 0; i < times; ++i) {
    backoff.trip(0);
    backoff.arm(kReason, 0);
  }
  backoff.trip(0);
  return backoff;
}

TEST(RearmBackoff, ThreeAreImmediateThenTheWaitDoubles) {
  for (const int times : {0, 1, 2}) EXPECT_EQ(after(times).wait(kReason, 0), 0);
  EXPECT_EQ(after(3).wait(kReason, 0), 10 * kTicksPerSecond);
  EXPECT_EQ(after(4).wait(kReason, 0), 20 * kTicksPerSecond);
  EXPECT_EQ(after(8).wait(kReason, 0), 320 * kTicksPerSecond);
  EXPECT_EQ(after(9).wait(kReason, 0), 600 * kTicksPerSecond);
  EXPECT_EQ(after(256).wait(kReason, 0), 600 * kTicksPerSecond) << "the count ends at 255";
  EXPECT_EQ(after(1000).wait(kReason, 0), 600 * kTicksPerSecond);
}

TEST(RearmBackoff, TheWaitBeginsWithTheTrip) {
  const RearmBackoff backoff = after(3);
  EXPECT_EQ(backoff.wait(kReason, 4000), 6000);
  EXPECT_EQ(backoff.wait(kReason, 10'000), 0);
  EXPECT_EQ(backoff.wait(kReason, 1'000'000), 0);
}

TEST(RearmBackoff, IsOfTheSameReasonAndOfTripsOnly) {
  RearmBackoff backoff = after(5);
  EXPECT_EQ(backoff.wait(Reason::kSensorOpen, 0), 0);
  EXPECT_EQ(backoff.wait(Reason::kNone, 0), 0);
  for (int i = 0; i < 10; ++i) backoff.arm(Reason::kEmergencyStop, 0);
  EXPECT_EQ(backoff.wait(Reason::kEmergencyStop, 0), 0) << "whoever stops it may go on";
}

TEST(RearmBackoff, CountsTripsOnly) {
  RearmBackoff backoff;
  backoff.arm(Reason::kNone, 0);
  backoff.arm(Reason::kEmergencyStop, 0);
  EXPECT_EQ(backoff.counts(), RearmCounts{});
  RearmCounts saved{};
  saved[static_cast<std::size_t>(Reason::kEmergencyStop)] = 10;
  EXPECT_EQ(RearmBackoff(saved).wait(Reason::kEmergencyStop, 0), 0);
}

TEST(RearmBackoff, OnlyTimeArmedCounts) {
  RearmBackoff late = after(4);
  late.arm(kReason, 400'000);
  const RearmCounts armed = late.counts();
  late.step(true, 400'001);
  EXPECT_EQ(late.counts(), armed);
  RearmBackoff backoff = after(4);
  for (Tick now = 1; now < 2 * RearmBackoff::kResetAfter; now += 1000) backoff.step(false, now);
  EXPECT_EQ(backoff.counts(), after(4).counts());
}

TEST(RearmBackoff, FiveMinutesArmedRemoveOneTrip) {
  RearmBackoff backoff = after(4);
  backoff.arm(kReason, 0);
  Tick now = 0;
  const auto armed_for = [&](Tick ticks) {
    for (const Tick until = now + ticks; now < until;) backoff.step(true, ++now);
  };
  const auto count = [&] { return int{backoff.counts()[static_cast<std::size_t>(kReason)]}; };
  armed_for(RearmBackoff::kResetAfter - 1);
  EXPECT_EQ(count(), 5);
  armed_for(1);
  EXPECT_EQ(count(), 4);
  armed_for(RearmBackoff::kResetAfter - 1);
  EXPECT_EQ(count(), 4) << "each takes five minutes";
  armed_for(10 * RearmBackoff::kResetAfter);
  EXPECT_EQ(count(), 0);

  backoff = after(4);
  backoff.step(false, now);
  for (int i = 0; i < 10; ++i) {
    armed_for(RearmBackoff::kResetAfter / 2);
    backoff.step(false, now);
  }
  EXPECT_EQ(count(), 4) << "each trip begins it anew";
}

RC_GTEST_PROP(RearmBackoff, WaitsNeverLongerThanTenMinutesAndEnd, ()) {
  const RearmBackoff backoff = after(*rc::gen::inRange(0, 300));
  const Tick now = *rc::gen::inRange<Tick>(0, 2'000'000);
  const Tick wait = backoff.wait(kReason, now);
  RC_ASSERT(wait >= 0 && wait <= RearmBackoff::kMaxWait);
  RC_ASSERT(backoff.wait(kReason, now + wait) == 0);
}

}  // namespace
}  // namespace hedgehog::control
