// SPDX-License-Identifier: MIT
// Estimates of the filter from energy, resistance and thermistors, each correct or wrong.
#include "model/estimate/thermal_filter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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
