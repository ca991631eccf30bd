// SPDX-License-Identifier: MIT
// The limiter's law (daemon/safety.md), and its effect on a requested current.
#include "model/limit/thermal_limiter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>

#include "model/limit/forecast.h"
#include "tests/model/non_finite.h"

namespace hedgehog::model {
namespace {

static_assert(std::is_trivially_copyable_v<ThermalLimiter>);
static_assert(std::is_trivially_copyable_v<ThermalObserver>);
static_assert(!std::is_constructible_v<LimitedCurrents, Vec3>);

double allowed(double celsius) { return allowed_current(Limits{}, Celsius(celsius)).value; }

ThermalEstimate at(double hottest_c) {
  ThermalEstimate estimate;
  estimate.hottest_c = hottest_c;
  estimate.measured = {true, true, true};
  return estimate;
}

Vec3 limited(const Vec3& requested, const ThermalEstimate& estimate) {
  ThermalLimiter limiter{Limits{}};
  return limiter.limit({requested}, estimate).a();
}

/// A number between `low` and `high`, from RapidCheck.
double any_number(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1'000'001) * 1e-6;
}

Limits any_limits() {
  Limits l;
  l.current_a = any_number(0.5, 15.0);
  l.continuous_a = any_number(0.5, l.current_a);
  l.derate_from_c = any_number(35.0, 60.0);
  l.sustain_c = any_number(l.derate_from_c, 67.0);
  l.zero_c = any_number(l.sustain_c, 69.0);
  return l;
}

TEST(ThermalLaw, IsTheOneOfTheDesign) {
  EXPECT_EQ(allowed(-40.0), 15.0);
  EXPECT_EQ(allowed(60.0), 15.0);
  for (const double t : {61.0, 63.5, 66.0, 67.0})
    EXPECT_NEAR(allowed(t), std::sqrt(25.0 + 200.0 * (67.0 - t) / 7.0), 1e-12);
  EXPECT_NEAR(allowed(68.0), 2.5, 1e-12);
  EXPECT_EQ(allowed(69.0), 0.0);
  EXPECT_EQ(allowed(1e6), 0.0);
}

TEST(ThermalLaw, NanAllowsNothing) {
  EXPECT_EQ(allowed(kNan), 0.0);
  EXPECT_EQ(allowed(kInfinity), 0.0);
  EXPECT_EQ(allowed(-kInfinity), 0.0);
}

TEST(ThermalLaw, WithEmptyRangesStepsDown) {
  Limits step;
  step.derate_from_c = step.sustain_c = step.zero_c = 60.0;
  EXPECT_EQ(allowed_current(step, Celsius(59.999)).value, 15.0);
  EXPECT_EQ(allowed_current(step, Celsius(60.0)).value, 0.0);
  step.zero_c = 69.0;
  EXPECT_EQ(allowed_current(step, Celsius(60.0)).value, 15.0);
  EXPECT_NEAR(allowed_current(step, Celsius(60.001)).value, 5.0, 1e-3);
}

RC_GTEST_PROP(ThermalLaw, NeverRisesWithTemperatureAndNeverExceedsTheLimits, ()) {
  const Limits limits = any_limits();
  const double cooler = any_number(0.0, 80.0);
  const double warmer = cooler + any_number(0.0, 20.0);
  const double low = allowed_current(limits, Celsius(warmer)).value;
  const double high = allowed_current(limits, Celsius(cooler)).value;
  RC_ASSERT(low <= high);
  RC_ASSERT(low >= 0.0);
  RC_ASSERT(high <= limits.current_a);
  if (warmer > limits.sustain_c) RC_ASSERT(low <= limits.continuous_a);
}

RC_GTEST_PROP(ThermalLaw, ItsInverseIsWhereTheForecastStops, ()) {
  const Limits limits = any_limits();
  const double peak = any_number(0.1, limits.current_a);
  const double t = derating_temperature(limits, Amps(peak)).value;
  RC_ASSERT(allowed_current(limits, Celsius(t - 0.01)).value >= peak * (1.0 - 1e-9));
  RC_ASSERT(allowed_current(limits, Celsius(t + 0.01)).value <= peak * (1.0 + 1e-9));
}

RC_GTEST_PROP(ThermalLimiter, ScalesTheVectorAsAWholeToWhatIsAllowed, ()) {
  const Limits limits = any_limits();
  ThermalLimiter limiter(limits);
  const Vec3 requested{any_number(-40, 40), any_number(-40, 40), any_number(-40, 40)};
  const double hottest = any_number(20.0, 75.0);
  const Vec3 got = limiter.limit({requested}, at(hottest)).a();
  const double max_a = allowed_current(limits, Celsius(hottest)).value;
  RC_ASSERT(limiter.allowed().value == max_a);
  RC_ASSERT(norm(got) <= max_a * (1.0 + 1e-12));
  RC_ASSERT(norm(got) <= norm(requested) * (1.0 + 1e-12));
  RC_ASSERT(norm(cross(got, requested)) <= 1e-9 * (1.0 + norm(got) * norm(requested)));
  RC_ASSERT(dot(got, requested) >= 0.0);
  if (norm(requested) <= max_a) RC_ASSERT(got == requested);
}

TEST(ThermalLimiter, PassesAllowedCurrentsUnchanged) {
  EXPECT_EQ(limited({3, -4, 12}, at(40.0)), (Vec3{3, -4, 12}));
  EXPECT_EQ(limited({0, 1, 0}, at(40.0)), (Vec3{0, 1, 0}));
  EXPECT_NEAR(norm(limited({30, 0, 40}, at(40.0))), 15.0, 1e-12);
}

TEST(ThermalLimiter, FollowsTheTemperatureWithinFiftyMilliseconds) {
  ThermalLimiter limiter{Limits{}};
  limiter.limit({{15, 0, 0}}, at(60.0));
  for (int tick = 0; tick < 50; ++tick) limiter.limit({{15, 0, 0}}, at(66.0));
  const double filtered_c = 66.0 - 6.0 * std::pow(1.0 - 1.0 / 50.0, 50);
  EXPECT_NEAR(limiter.allowed().value, allowed(filtered_c), 1e-9);
}

TEST(ThermalLimiter, AfterALongGapUsesTheTemperatureUnfiltered) {
  ThermalLimiter limiter{Limits{}};
  limiter.limit({{15, 0, 0}}, at(30.0));
  limiter.limit({{15, 0, 0}}, at(68.0), 0.5);
  EXPECT_NEAR(limiter.allowed().value, 2.5, 1e-12);
}

TEST(ThermalLimiter, AllowsNoMoreThanItsCeiling) {
  ThermalLimiter limiter{Limits{}};
  for (const double ceiling_a : {7.0, 0.5, 0.0}) {
    limiter.set_ceiling(Amps(ceiling_a));
    EXPECT_NEAR(norm(limiter.limit({{12, 0, 9}}, at(30.0)).a()), ceiling_a, 1e-12);
    EXPECT_EQ(limiter.allowed().value, ceiling_a);
  }
  for (const double none : {-1.0, kNan}) {
    limiter.set_ceiling(Amps(none));
    EXPECT_EQ(limiter.limit({{12, 0, 9}}, at(30.0)).a(), Vec3{});
    EXPECT_EQ(limiter.allowed().value, 0.0);
  }
  ThermalLimiter hot{Limits{}};
  hot.set_ceiling(Amps(7.0));
  EXPECT_EQ(hot.limit({{12, 0, 9}}, at(68.0)).a(), (2.5 * Vec3{0.8, 0, 0.6})) << "the law is less";
}

TEST(ThermalLimiter, AThousandAmpereIsStillAValidRequest) {
  ThermalLimiter limiter{Limits{}};
  EXPECT_EQ(limiter.limit({{1000, 0, 0}}, at(25.0)).a(), (Vec3{15, 0, 0}));
  EXPECT_FALSE(limiter.rejected());
}

TEST(ThermalLimiter, NonFiniteAndImplausibleRequestsBecomeZeroAndAreReported) {
  ThermalLimiter limiter{Limits{}};
  for (const Vec3& bad : {Vec3{kNan, 0, 0}, Vec3{0, kInfinity, 0}, Vec3{0, 0, -kInfinity},
                          Vec3{1e300, 1e300, 0}, Vec3{1001, 0, 0}}) {
    EXPECT_EQ(limiter.limit({bad}, at(25.0)).a(), Vec3{});
    EXPECT_TRUE(limiter.rejected());
  }
  EXPECT_EQ(limiter.limit({{5, 0, 0}}, at(25.0)).a(), (Vec3{5, 0, 0}));
  EXPECT_FALSE(limiter.rejected());
}

TEST(ThermalLimiter, AnUnknownTemperatureAllowsNothingAtOnce) {
  ThermalLimiter limiter{Limits{}};
  for (int tick = 0; tick < 1000; ++tick) limiter.limit({{5, 0, 0}}, at(30.0));
  for (const double unknown : {kInfinity, kNan}) {
    EXPECT_EQ(limiter.limit({{5, 0, 0}}, at(unknown)).a(), Vec3{});
    EXPECT_EQ(limiter.allowed().value, 0.0);
  }
  EXPECT_EQ(limiter.limit({{5, 0, 0}}, at(68.0)).a().x, 2.5) << "the filter restarts, not from 30";
}

TEST(ThermalLimiter, AnUnmeasuredWindingIsHeldToTheContinuousCurrentAndKeepsTheDirection) {
  ThermalEstimate estimate = at(30.0);
  estimate.measured = {false, true, true};
  const Vec3 held = limited({12, 9, 0}, estimate);
  EXPECT_NEAR(held.x, 5.0, 1e-12);
  EXPECT_NEAR(held.y, 3.75, 1e-12);
  EXPECT_EQ(limited({4, 9, 0}, estimate), (Vec3{4, 9, 0})) << "below the hold anyway";
  EXPECT_EQ(limited({0, 12, 5}, estimate), (Vec3{0, 12, 5})) << "not driven: holds nobody back";
}

TEST(ThermalLimiter, NewLimitsHoldFromTheNextTick) {
  ThermalLimiter limiter{Limits{}};
  ASSERT_EQ(limiter.limit({{15, 0, 0}}, at(30.0)).a().x, 15.0);
  Limits tight;
  tight.current_a = 3.0;
  tight.continuous_a = 2.0;
  limiter.set_limits(tight);
  EXPECT_EQ(limiter.limit({{15, 0, 0}}, at(30.0)).a().x, 3.0);
}

}  // namespace
}  // namespace hedgehog::model
