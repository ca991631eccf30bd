// SPDX-License-Identifier: MIT
// The forecast compared with the subsequent behaviour of the plant.
#include "model/limit/forecast.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "model/limit/shell_limit.h"
#include "model/thermal/fan.h"
#include "model/thermal/plant.h"
#include "tests/model/thermal_loop.h"

namespace hedgehog::model {
namespace {

const Forecaster kNominal{CoilModel{}, ThermalModel{}, Limits{}};
constexpr auto constant = &RequestedCurrents::constant;

ForecastStart cold() { return {}; }

/// The whole ball at `celsius`, ambient 25 C.
ForecastStart warm(double celsius) {
  ForecastStart start;
  start.nodes = {{celsius, celsius, celsius}, celsius};
  start.fan_running = celsius > Fan::kOnAboveC;
  return start;
}

/// The state of that ball as estimated by the limiter's observer.
ForecastStart measured(ForecastStart start) {
  ThermalLoop loop(PlantParameters{}, start.ambient_c);
  loop.start_at(start.nodes);
  start.above_k = loop.observer.estimate().hottest_c - hottest_winding(start.nodes);
  return start;
}

/// Seconds until the limiter first reduces a current in the closed loop; -1: not within 4 h.
double loop_seconds_to_derating(const ForecastStart& start, const Vec3& current) {
  ThermalLoop loop(PlantParameters{}, start.ambient_c);
  loop.start_at(start.nodes);
  for (int tick = 1; tick < 4 * 3600 * 1000; ++tick) {
    loop.tick(current);
    if (norm(loop.driven) < norm(current) - 1e-6) return tick * 1e-3;
  }
  return -1.0;
}

TEST(Forecast, AgreesWithThePlantWithin5PercentFromColdAndWarm) {
  for (const double celsius : {25.0, 45.0}) {
    const ForecastStart start = measured(warm(celsius));
    for (const double current : {6.0, 8.0, 10.0, 12.0, 15.0}) {
      const auto forecast_s = kNominal.seconds_to_derating(start, constant({0, current, 0}));
      ASSERT_TRUE(forecast_s.has_value());
      const double real = loop_seconds_to_derating(start, {0, current, 0});
      EXPECT_NEAR(*forecast_s, real, 0.05 * real) << current << " A from " << celsius << " C";
    }
  }
}

TEST(Forecast, AgreesWithThePlantOverLongTimes) {
  const ForecastStart start = measured(cold());
  const double edge = kNominal.sustainable_a(start, constant({0, 0, 1}));
  for (const double current : {1.03 * edge, 1.1 * edge}) {
    const auto forecast_s = kNominal.seconds_to_derating(start, constant({0, 0, current}));
    ASSERT_TRUE(forecast_s.has_value());
    EXPECT_GT(*forecast_s, 300.0);
    const double real = loop_seconds_to_derating(start, {0, 0, current});
    EXPECT_NEAR(*forecast_s, real, 0.05 * real) << current << " A";
  }
}

TEST(Forecast, AllFiguresAtOnceEqualThoseComputedSeparately) {
  for (const double current : {2.4, 5.0, 5.6, 9.0, 15.0}) {
    ForecastStart start = warm(62.0);
    start.nodes.winding_c = {61.0, 64.0, 62.0};
    start.mean_current_a = 4.0;
    const Forecast worst = kNominal.forecast_worst_coil(start, current);
    EXPECT_EQ(worst.recovery_s, kNominal.recovery_s(start));
    ASSERT_TRUE(worst.recovery_s.has_value());
    EXPECT_GT(*worst.recovery_s, 0.0);
    std::optional<double> first;
    for (const Vec3& along : {Vec3{current, 0, 0}, Vec3{0, current, 0}, Vec3{0, 0, current}}) {
      const RequestedCurrents requested = constant(along);
      const Forecast one = kNominal.forecast(start, requested);
      EXPECT_EQ(one.seconds_to_derating, kNominal.seconds_to_derating(start, requested));
      EXPECT_EQ(one.recovery_s, worst.recovery_s);
      EXPECT_LE(one.seconds_to_derating.value_or(1e9), one.seconds_to_limit.value_or(1e9));
      if (one.seconds_to_derating) first = std::min(first.value_or(1e9), *one.seconds_to_derating);
    }
    EXPECT_EQ(worst.seconds_to_derating, first) << current << " A";
  }
}

RC_GTEST_PROP(Forecast, SecondsToDeratingAreThoseOfTheFullForecast, ()) {
  const auto within = [](const char* what, int low, int high) {
    return 0.1 * *rc::gen::inRange(10 * low, 10 * high).as(what);
  };
  ForecastStart start;
  start.ambient_c = within("ambient", 10, 40);
  for (double& winding_c : start.nodes.winding_c) winding_c = within("winding", 10, 75);
  start.nodes.core_c = within("core", 10, 65);
  start.above_k = within("above", 0, 8);
  start.skin_above_k =
      *rc::gen::arbitrary<bool>() ? within("skin", 0, 5) : -std::numeric_limits<double>::infinity();
  start.fan_works = *rc::gen::arbitrary<bool>();
  start.mean_current_a = within("mean", 0, 10);
  const auto requested = constant({within("x", -6, 6), within("y", -6, 6), within("z", -3, 3)});
  const Forecast run_ahead = kNominal.forecast(start, requested);
  RC_ASSERT(kNominal.seconds_to_derating(start, requested) == run_ahead.seconds_to_derating);
}

TEST(Forecast, SecondsToLimitAreThoseOfTheUnlimitedPlant) {
  for (const double current : {8.0, 10.0, 12.0, 15.0}) {
    ThermalLoop loop(PlantParameters{}, 25.0);
    loop.unlimited = true;
    double real = 0.0;
    while (loop.plant.hottest_winding_c() < 70.0) {
      loop.tick({current, 0, 0});
      real += 1e-3;
    }
    const Forecast f = kNominal.forecast(cold(), constant({current, 0, 0}));
    ASSERT_TRUE(f.seconds_to_limit.has_value());
    EXPECT_NEAR(*f.seconds_to_limit, real, 0.05 * real);
  }
  const auto at15 = kNominal.forecast(cold(), constant({15, 0, 0}));
  EXPECT_NEAR(*at15.seconds_to_limit, 29.6, 0.5);
  EXPECT_NEAR(*at15.seconds_to_derating, 22.0, 1.0);
}

TEST(Forecast, FiveAmpereAreAllowedForEver) {
  for (const Vec3& current : {Vec3{5, 0, 0}, Vec3{0, -5, 0}, Vec3{0, 0, 5}, Vec3{3, 4, 0}}) {
    const Forecast f = kNominal.forecast(cold(), constant(current));
    EXPECT_FALSE(f.seconds_to_derating.has_value());
    EXPECT_FALSE(f.seconds_to_limit.has_value());
    EXPECT_GT(f.sustainable_a, 5.0);
  }
}

TEST(Forecast, TheIndicatorsPulsesAreAllowedForEver) {
  const RequestedCurrents pulses{{0, 0, 12.0 * std::sqrt(0.15)}, 12.0};
  const Forecast f = kNominal.forecast(cold(), pulses);
  EXPECT_FALSE(f.seconds_to_derating.has_value());
  EXPECT_GT(f.sustainable_a, 12.0);
}

TEST(Forecast, SustainableIsTheBoundary) {
  const Vec3 directions[] = {{1, 0, 0}, {0.6, 0.8, 0}, {0.577, 0.577, -0.577}};
  for (const Vec3& direction : directions) {
    const Vec3 u = unit_or(direction, {1, 0, 0});
    const double edge = kNominal.sustainable_a(cold(), constant(u));
    EXPECT_FALSE(kNominal.seconds_to_derating(cold(), constant(0.99 * edge * u)).has_value());
    EXPECT_TRUE(kNominal.seconds_to_derating(cold(), constant(1.03 * edge * u)).has_value());
  }
  const double one = kNominal.sustainable_a(cold(), constant({1, 0, 0}));
  const double shared = kNominal.sustainable_a(cold(), constant({1, 1, 1}));
  EXPECT_GT(shared, one) << "three windings share the heat";
}

TEST(Forecast, RecoveryIsWhatTheLimiterThenAllows) {
  ThermalLoop loop(PlantParameters{}, 25.0);
  for (int tick = 0; tick < 60'000; ++tick) loop.tick({15, 0, 0});
  ASSERT_LT(loop.limiter.allowed().value, 15.0);
  ForecastStart start;
  start.nodes = loop.observer.estimate().nodes;
  start.ambient_c = loop.observer.estimate().ambient_c;
  start.above_k = loop.observer.estimate().hottest_c - hottest_winding(start.nodes);
  start.fan_running = true;
  start.mean_current_a = 10.0;
  const auto forecast_s = kNominal.recovery_s(start);
  ASSERT_TRUE(forecast_s.has_value());
  double real = 0.0;
  while (loop.limiter.allowed().value < 15.0 && real < 600.0) {
    loop.tick({});
    real += 1e-3;
  }
  EXPECT_NEAR(*forecast_s, real, 0.1 * real);
  EXPECT_EQ(kNominal.recovery_s(cold()), 0.0);
  ForecastStart hot_ambient = warm(65.0);
  hot_ambient.ambient_c = 62.0;
  EXPECT_FALSE(kNominal.recovery_s(hot_ambient).has_value());
}

TEST(Forecast, BurstIsThatOfTheWorstCoil) {
  CoilModel uneven;
  uneven.r25_ohm = {0.40, 0.45, 0.55};
  const Forecaster forecaster(uneven, ThermalModel{}, Limits{});
  const auto burst = forecaster.burst_s(cold());
  ASSERT_TRUE(burst.has_value());
  EXPECT_EQ(burst, forecaster.seconds_to_derating(cold(), constant({0, 0, 15})));
  EXPECT_EQ(forecaster.forecast_worst_coil(cold(), 15.0).seconds_to_derating, burst);
  EXPECT_NEAR(*kNominal.burst_s(cold()), 22.5, 0.5);
  ForecastStart hot = warm(40.0);
  hot.nodes.winding_c[1] = 60.5;
  EXPECT_EQ(kNominal.burst_s(hot), 0.0);
}

TEST(Forecast, ADeadFanShortensEverything) {
  ForecastStart dead = cold();
  dead.fan_works = false;
  EXPECT_TRUE(kNominal.seconds_to_derating(dead, constant({5, 0, 0})).has_value());
  EXPECT_LT(kNominal.forecast_worst_coil(dead, 5.0).sustainable_a, 4.0);
}

TEST(Forecast, ZeroIsNeverReduced) {
  const Forecast f = kNominal.forecast(cold(), RequestedCurrents{});
  EXPECT_FALSE(f.seconds_to_derating.has_value());
  EXPECT_FALSE(f.seconds_to_limit.has_value());
  EXPECT_GT(f.sustainable_a, 5.0);
}

RC_GTEST_PROP(Forecast, MoreCurrentOrAWarmerBallIsNeverForecastLonger, ()) {
  const auto between = [](double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 100'001) * 1e-5;
  };
  const double current = between(4.0, 14.0);
  const double celsius = between(18.0, 58.0);
  const auto seconds = [](double a, double c) {
    return kNominal.seconds_to_derating(warm(c), constant({a, 0, 0})).value_or(1e9);
  };
  const double base = seconds(current, celsius);
  RC_ASSERT(seconds(current + between(0.1, 1.0), celsius) <= base);
  RC_ASSERT(seconds(current, celsius + between(0.1, 5.0)) <= base * 1.02 + 0.1);
}

/// A limiting skin, on a ball that has long been in the state `start`.
ForecastStart with_skin(ForecastStart start) {
  start.skin = SkinEstimate(ThermalModel{});
  start.skin_above_k = SkinEstimate::kMinMarginK;
  return start;
}

/// Seconds until the plant's estimated skin first limits the current; -1: not within an hour.
double plant_seconds_to_skin(double ambient_c, const Vec3& current) {
  const double current_a = norm(current);
  Plant plant(PlantParameters{}, ambient_c);
  SkinEstimate skin{ThermalModel{}};
  constexpr double kStepS = 0.02;
  for (int step = 0; step < 180'000; ++step) {
    SkinInputs in;
    in.nodes = plant.heat();
    in.ambient_c = ambient_c;
    in.to_ambient_k_w = plant.fan_rpm() > 300.0 ? 1.8 : 5.0;
    skin.step(in, kStepS);
    if (shell_allowed_current(Limits{}, skin.celsius()).value < current_a - 1e-6)
      return step * kStepS;
    plant.step_thermal({current.x * current.x, current.y * current.y, current.z * current.z}, 1.0,
                       kStepS);
  }
  return -1.0;
}

TEST(Forecast, ForecastsTheSkinWithin5Percent) {
  for (const double ambient_c : {25.0, 32.0}) {
    ForecastStart start = warm(ambient_c);
    start.ambient_c = ambient_c;
    start = with_skin(start);
    for (const double current_a : {6.0, 9.0, 15.0}) {
      const double each_a = current_a / std::sqrt(3.0);
      const Vec3 current{each_a, -each_a, each_a};
      const auto forecast_s = kNominal.seconds_to_derating(start, constant(current));
      ASSERT_TRUE(forecast_s.has_value());
      const double real = plant_seconds_to_skin(ambient_c, current);
      EXPECT_NEAR(*forecast_s, real, 0.05 * real) << current_a << " A at " << ambient_c << " C";
    }
  }
}

TEST(Forecast, TheSkinAllowsFiveAmpereForEverOnlyInACoolAmbient) {
  const auto sustained = [](double ambient_c, double above_k) {
    ForecastStart start = with_skin(warm(ambient_c));
    start.ambient_c = ambient_c;
    start.skin_above_k = above_k;
    return kNominal.sustainable_a(start, constant({1, 0, 0}));
  };
  EXPECT_GE(sustained(25.0, SkinEstimate::kMinMarginK), 5.0);
  EXPECT_NEAR(sustained(32.0, SkinEstimate::kMinMarginK), 3.9, 0.2);
  EXPECT_EQ(sustained(32.0, -5.0), sustained(32.0, -std::numeric_limits<double>::infinity()))
      << "a probe under a shell that insulates leaves what the windings leave";
  EXPECT_EQ(sustained(25.0, std::numeric_limits<double>::infinity()), 0.0) << "a silent probe";
}

TEST(Forecast, RecoveryWaitsForTheSkinToo) {
  ForecastStart start = warm(50.0);
  const auto winding_s = kNominal.recovery_s(start);
  const auto skin_s = kNominal.recovery_s(with_skin(start));
  EXPECT_EQ(winding_s, 0.0);
  ASSERT_TRUE(skin_s.has_value());
  EXPECT_GT(*skin_s, 60.0);
  EXPECT_EQ(kNominal.burst_s(with_skin(start)), 0.0);
}

}  // namespace
}  // namespace hedgehog::model
