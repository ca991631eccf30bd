// SPDX-License-Identifier: MIT
// Estimates of the filter from energy, resistance and thermistors, each correct or wrong.
#include "model/estimate/thermal_filter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <type_traits>

#include "model/thermal/plant.h"

namespace hedgehog::model {
namespace {

static_assert(std::is_trivially_copyable_v<ThermalFilter>);

constexpr double kWindowS = 0.1;
constexpr double kMeter = 0.002;

FilterStart all_at(double celsius) {
  FilterStart start;
  start.nodes = {{celsius, celsius, celsius}, celsius};
  start.ambient_c = celsius;
  return start;
}

ThermalFilter filter_at(double celsius, const ThermalUncertainty& uncertainty = {}) {
  return {CoilModel{}, ThermalModel{}, uncertainty, all_at(celsius)};
}

/// A plant and the filter that follows it; winding 0 carries `current_a`.
struct FollowedBall {
  explicit FollowedBall(const PlantParameters& parameters, double ambient_c = 25.0)
      : plant(parameters, ambient_c), filter(filter_at(ambient_c)) {}

  void step(double current_a, double resistance_gain = 1.0) {
    const double ohm = plant.resistance_ohm(0);
    const double loss_w = ohm * current_a * current_a;
    for (int i = 0; i < 5; ++i) plant.step_thermal({current_a * current_a, 0, 0}, 0.0, 0.02);
    filter.predict({loss_w, 0, 0}, false, kWindowS);
    last = filter.resistance(0, std::log(resistance_gain * plant.resistance_ohm(0) / 0.45), kMeter,
                             1.0 / current_a);
    for (int coil = 0; coil < kCoils; ++coil) filter.thermistor(coil, plant.thermistor_c(coil));
  }

  Plant plant;
  ThermalFilter filter;
  Innovation last;
};

TEST(ThermalFilter, FollowsAMatchingBallWithinHalfAKelvin) {
  FollowedBall ball(PlantParameters{});
  for (int i = 0; i < 200; ++i) ball.step(12.0);
  ASSERT_GT(ball.plant.heat().winding_c[0], 40.0);
  EXPECT_NEAR(ball.filter.winding_c(0), ball.plant.heat().winding_c[0], 0.5);
  EXPECT_NEAR(ball.filter.winding_c(1), ball.plant.heat().winding_c[1], 0.5);
  EXPECT_NEAR(ball.filter.core_c(), ball.plant.heat().core_c, 0.5);
  EXPECT_LT(ball.filter.winding_deviation_k(0), 1.0);
}

TEST(ThermalFilter, PredictsTheBallOfItsFile) {
  ThermalModel file;
  file.winding_j_k = {40.0, 60.0, 90.0};
  file.winding_to_core_k_w = {0.6, 1.5, 2.2};
  file.core_j_k = 150.0;
  file.sensor_lag_s = 3.0;
  Plant plant(PlantParameters::of(CoilModel{}, file), 25.0);
  PlantErrors errors;
  errors.lost_contact.fill(0.05);
  plant.set_errors(errors);
  ThermalFilter filter(CoilModel{}, file, {}, all_at(25.0));
  const Vec3 square_a2{50.0, 20.0, 30.0};
  for (int window = 0; window < 1200; ++window) {
    std::array<double, kCoils> loss_w{};
    for (int coil = 0; coil < kCoils; ++coil)
      loss_w[static_cast<std::size_t>(coil)] = plant.resistance_ohm(coil) * square_a2[coil];
    const bool fan = window >= 600;
    for (int i = 0; i < 5; ++i) plant.step_thermal(square_a2, fan ? 1.0 : 0.0, 0.02);
    filter.predict(loss_w, fan, kWindowS);
  }
  for (int coil = 0; coil < kCoils; ++coil) {
    EXPECT_NEAR(filter.winding_c(coil), plant.heat().winding_c[static_cast<std::size_t>(coil)],
                0.1);
    EXPECT_NEAR(filter.thermistor_c(coil), plant.thermistor_c(coil), 0.1);
  }
  EXPECT_NEAR(filter.core_c(), plant.heat().core_c, 0.1);
  ASSERT_GT(filter.core_c(), 35.0);
}

TEST(ThermalFilter, AThermistorQuickerThanAStepShowsItsWinding) {
  ThermalModel file;
  file.sensor_lag_s = 0.1;
  FilterStart start = all_at(60.0);
  start.nodes.core_c = 20.0;
  ThermalFilter filter(CoilModel{}, file, {}, start);
  filter.predict({}, false, 0.3);
  EXPECT_NEAR(filter.thermistor_c(0), 60.0 - 0.05 * 40.0, 1e-9);
}

TEST(ThermalFilter, EstimatesAResistanceThatDiffersFromTheFile) {
  PlantParameters real;
  real.r25_ohm[0] *= 1.04;
  FollowedBall ball(real);
  for (int i = 0; i < 200; ++i) ball.step(12.0);
  EXPECT_NEAR(ball.filter.resistance_drift(0), std::log(1.04), 0.005);
  EXPECT_NEAR(ball.filter.winding_c(0), ball.plant.heat().winding_c[0], 1.0);
  EXPECT_NEAR(ball.filter.resistance_ohm(0), ball.plant.resistance_ohm(0), 0.005);
}

TEST(ThermalFilter, AResistanceThatJumpsIsNotUsed) {
  FollowedBall ball(PlantParameters{});
  for (int i = 0; i < 100; ++i) ball.step(12.0);
  EXPECT_TRUE(ball.last.used);
  const double before_c = ball.filter.winding_c(0);
  ball.step(12.0, 0.92);
  EXPECT_FALSE(ball.last.used);
  EXPECT_LT(ball.last.deviations, -ThermalFilter::kGate);
  EXPECT_NEAR(ball.last.difference, std::log(0.92), 0.01);
  EXPECT_GT(ball.filter.winding_c(0), before_c - 0.2) << "it does not take it for cooling";
}

TEST(ThermalFilter, AnIdleCurrentIsItsOffset) {
  ThermalFilter filter = filter_at(25.0);
  filter.set_current_accuracy({0.05, 0.03, true});
  for (int i = 0; i < 50; ++i) filter.idle_current(2, 0.02);
  EXPECT_NEAR(filter.current_offset_a(2), 0.02, 0.003);
  EXPECT_EQ(filter.current_offset_a(0), 0.0);
  filter.set_current_accuracy({0.1, 0.1, false});
  EXPECT_EQ(filter.current_offset_a(2), 0.0) << "another board";
}

TEST(ThermalFilter, TheOffsetOfAnotherBoardIsIndependentOfTheTemperatures) {
  FollowedBall ball(PlantParameters{});
  ThermalFilter& filter = ball.filter;
  filter.set_current_accuracy({0.05, 0.03, true});
  for (int i = 0; i < 100; ++i) ball.step(6.0);
  ThermalFilter same = filter;
  same.idle_current(0, 0.05);
  EXPECT_GT(std::abs(same.winding_c(0) - filter.winding_c(0)), 1e-4);
  filter.set_current_accuracy({0.05, 0.06, true});
  const ThermalFilter before = filter;
  filter.idle_current(0, 0.05);
  EXPECT_GT(filter.current_offset_a(0), 0.01);
  EXPECT_EQ(filter.winding_c(0), before.winding_c(0));
  EXPECT_EQ(filter.resistance_drift(0), before.resistance_drift(0));
}

TEST(ThermalFilter, AnOffsetIsAtMostTwiceTheTolerance) {
  for (const double tolerance_a : {0.03, 0.06})
    for (const double sign : {-1.0, 1.0}) {
      ThermalFilter filter = filter_at(25.0);
      filter.set_current_accuracy({0.05, tolerance_a, true});
      for (int i = 0; i < 50; ++i) filter.idle_current(1, sign * 3.5 * tolerance_a);
      EXPECT_DOUBLE_EQ(filter.current_offset_a(1), sign * 2.0 * tolerance_a);
    }
}

/// The cooling after an hour in which the core's real cooling differs from the file's by `gain`.
double cooling_found(double gain) {
  PlantParameters real;
  real.core_to_ambient_still_k_w /= gain;
  FollowedBall ball(real);
  for (int i = 0; i < 36'000; ++i) ball.step(6.0);
  return ball.filter.cooling();
}

TEST(ThermalFilter, FindsACoolingThatDiffersFromTheFile) {
  EXPECT_NEAR(cooling_found(1.0), 1.0, 0.05);
  EXPECT_NEAR(cooling_found(0.6), 0.6, 0.05);
}

TEST(ThermalFilter, TakesNoCoolingForPossibleThatIsFarFromTheFile) {
  EXPECT_NEAR(cooling_found(5.0), std::exp(0.7), 0.05);
  EXPECT_NEAR(cooling_found(0.1), std::exp(-1.2), 0.05);
}

TEST(ThermalFilter, TheLostContactOfAThermistorIsLimitedToThreeFifths) {
  ThermalFilter filter = filter_at(25.0);
  double excess_k = 0.0;
  const auto window = [&] {
    filter.predict({60.0, 0, 0}, false, kWindowS);
    excess_k = filter.winding_c(0) - filter.core_c();
    const double ohm = 1.0 + kCopperPerKelvin * (filter.winding_c(0) - 25.0);
    filter.resistance(0, std::log(ohm), kMeter, 0.1);
  };
  for (int i = 0; i < 20'000; ++i) {
    window();
    filter.thermistor(0, filter.thermistor_c(0) + filter.thermistor_offset_k(0) - 1.5);
  }
  for (int i = 0; i < 600; ++i) window();
  EXPECT_NEAR((filter.thermistor_c(0) - filter.core_c()) / excess_k, 0.4, 0.02);
}

TEST(ThermalFilter, WithoutMeasurementsItsUncertaintyGrows) {
  ThermalFilter filter = filter_at(25.0);
  double before_k = filter.winding_deviation_k(1);
  for (int minute = 0; minute < 10; ++minute) {
    for (int i = 0; i < 600; ++i) filter.predict({0, 8.0, 0}, false, kWindowS);
    EXPECT_GT(filter.winding_deviation_k(1), before_k);
    before_k = filter.winding_deviation_k(1);
  }
  EXPECT_GT(before_k, 1.0) << "20 % of capacities and conductances are kelvins";
}

TEST(ThermalFilter, HoweverLongNothingIsMeasuredItsCoolingIsKnownToAHalf) {
  ThermalFilter filter = filter_at(25.0);
  for (int i = 0; i < 240'000; ++i) filter.predict({1.0, 1.0, 1.0}, false, 0.3);
  const double above_k = filter.core_c() - 25.0;
  EXPECT_NEAR(filter.between_deviation_k(1.0), std::hypot(3.0, 0.5 * above_k), 0.1 * above_k);
}

TEST(ThermalFilter, WellKnownConstantsReduceTheUncertainty) {
  ThermalUncertainty calibrated;
  calibrated.thermal = 0.05;
  ThermalFilter vague = filter_at(25.0);
  ThermalFilter exact = filter_at(25.0, calibrated);
  for (int i = 0; i < 300; ++i) {
    vague.predict({0, 60.0, 0}, false, kWindowS);
    exact.predict({0, 60.0, 0}, false, kWindowS);
  }
  EXPECT_LT(exact.winding_deviation_k(1), 0.5 * vague.winding_deviation_k(1));
}

RC_GTEST_PROP(ThermalFilter, StaysFiniteWithBoundedUncertaintyForAnyMeasurement, ()) {
  ThermalFilter filter = filter_at(25.0);
  const auto number = [](double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1'000'001) * 1e-6;
  };
  for (int i = 0; i < 300; ++i) {
    filter.predict({number(0, 150), number(0, 150), number(0, 150)}, *rc::gen::arbitrary<bool>(),
                   number(0.02, 0.3));
    const int coil = *rc::gen::inRange(0, 3);
    filter.resistance(coil, number(-1, 1), number(1e-3, 0.1), number(-1, 1));
    filter.thermistor(coil, number(-20, 125));
    filter.idle_current(coil, number(-1, 1));
    for (int each = 0; each < kCoils; ++each) {
      RC_ASSERT(std::isfinite(filter.winding_c(each)));
      RC_ASSERT(std::isfinite(filter.winding_deviation_k(each)));
      RC_ASSERT(std::isfinite(filter.resistance_ohm(each)));
      RC_ASSERT(filter.winding_deviation_k(each) >= 0.0);
    }
  }
}

}  // namespace
}  // namespace hedgehog::model
