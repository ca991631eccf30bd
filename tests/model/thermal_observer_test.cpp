// SPDX-License-Identifier: MIT
// The observer's estimates of windings without a thermistor, on balls that differ from the nominal
// model.
#include "model/estimate/thermal_observer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tests/model/non_finite.h"
#include "tests/model/thermal_loop.h"
#include "tests/model/thermal_measurements.h"

namespace hedgehog::model {
namespace {

TEST(ThermalObserver, FindsAWindingThatBurnsWhileTheThermistorStaysCool) {
  ThermalObserver observer;
  for (int tick = 0; tick < 500; ++tick) observer.step(measurement(2, 5.0, 65.0, 25.0));
  // Only V/I is available, with a resistance that may be off by some per cent.
  EXPECT_GT(observer.estimate().upper_c[2], 65.0);
  EXPECT_GT(observer.estimate().hottest_c, 65.0);
  EXPECT_NEAR(observer.estimate().resistance_ohm[2], resistance_at(Ohms(0.45), Celsius(65.0)).value,
              0.001);
}

// Neither floor depends on the filter, nor on the other floor.
TEST(ThermalObserver, TheBoundIsByResistanceWhereTheFilterDoesNotUseIt) {
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(25.0));
  for (int tick = 0; tick < 1000; ++tick) observer.step(measurement(1, 10.0, 25.0, 25.0));
  ASSERT_TRUE(observer.winding(1).referenced());
  for (int tick = 0; tick < 1000; ++tick) observer.step(measurement(1, 10.0, 68.0, 25.0));
  EXPECT_FALSE(observer.innovations(1).resistance.used);
  EXPECT_LT(observer.filter().winding_c(1), 40.0);
  EXPECT_GT(observer.estimate().upper_c[1], 66.0);
}

TEST(ThermalObserver, TheBoundIsByEnergyWithoutResistanceAndThermistor) {
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(25.0));
  for (int tick = 0; tick < 25'000; ++tick) observer.step(measurement(1, 15.0, 25.0, 25.0));
  // 100 W into 59 J/K, with a 20 % tolerance on both, and some heat into the core.
  EXPECT_GT(observer.estimate().upper_c[1], 45.0);
  EXPECT_GT(observer.estimate().hottest_c, 45.0);
}

TEST(ThermalObserver, MarksAWindingMeasuredWithinTensOfMillisecondsAndOnlyThatOne) {
  ThermalObserver observer;
  EXPECT_EQ(observer.estimate().measured, (std::array<bool, kCoils>{}));
  for (int tick = 0; tick < 50; ++tick) observer.step(measurement(1, 5.0, 40.0, 40.0));
  EXPECT_EQ(observer.estimate().measured, (std::array<bool, kCoils>{false, true, false}));
  EXPECT_EQ(observer.estimate().measuring, (std::array<bool, kCoils>{false, true, false}));
  for (int tick = 0; tick < 1000; ++tick) observer.step(measurement(0, 1.0, 40.0, 40.0));
  EXPECT_EQ(observer.estimate().measured, (std::array<bool, kCoils>{false, true, false}))
      << "below 1.5 A V/I says nothing; what was measured stays measured";
  EXPECT_EQ(observer.estimate().measuring, (std::array<bool, kCoils>{}));
}

TEST(ThermalObserver, TheThermistorCountsWithALeadOfTwoSeconds) {
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(30.0));
  double body_c = 30.0;
  for (int tick = 0; tick < 10'000; ++tick) {
    body_c += 1.5e-3;  // 1.5 K/s
    observer.step(quiet(body_c));
  }
  EXPECT_NEAR(observer.estimate().sensor_lead_c, body_c + 3.0, 0.1);
  EXPECT_GT(observer.estimate().hottest_c, body_c + 0.4);
}

TEST(ThermalObserver, ASilentThermistorNeverMakesItCoolerAndSoonCountsAsHot) {
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(50.0));
  for (int tick = 0; tick < 3000; ++tick) observer.step(quiet(58.0));
  const double before = observer.estimate().hottest_c;
  ThermalMeasurement silent = quiet(20.0);
  silent.thermistors.valid[0] = false;
  for (int tick = 0; tick < 90; ++tick) {
    observer.step(silent);
    EXPECT_GE(observer.estimate().hottest_c, before - 0.05);
  }
  for (int tick = 0; tick < 20; ++tick) observer.step(silent);
  EXPECT_TRUE(std::isinf(observer.estimate().hottest_c));
  for (int tick = 0; tick < 10; ++tick) observer.step(quiet(57.0));
  EXPECT_LT(observer.estimate().hottest_c, 62.0) << "and it comes back";
  EXPECT_GT(observer.estimate().hottest_c, 57.0);
}

TEST(ThermalObserver, OneReadingOfAThermistorInAWindowIsUsed) {
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(25.0));
  const auto used_with_readings = [&](int readings) {
    for (int tick = 0; tick < 100; ++tick) {
      ThermalMeasurement m = quiet(25.0);
      m.thermistors.valid[0] = tick < readings;
      observer.step(m);
    }
    return observer.innovations(0).thermistor_known;
  };
  EXPECT_TRUE(used_with_readings(1));
  EXPECT_FALSE(used_with_readings(0));
}

TEST(ThermalObserver, WithoutAnyThermistorFromTheStartNothingIsAllowed) {
  ThermalObserver observer;
  ThermalMeasurement silent;
  for (int tick = 0; tick < 200; ++tick) observer.step(silent);
  EXPECT_TRUE(std::isinf(observer.estimate().hottest_c));
}

TEST(ThermalObserver, AnImpossibleResistanceStaysWithinAFactorOfTwo) {
  for (const double factor : {-1.0, 0.0, 0.01, 100.0}) {
    ThermalObserver observer(CoilModel{}, ThermalModel{}, known(25.0));
    for (int tick = 0; tick < 1000; ++tick) {
      ThermalMeasurement m = measurement(1, 10.0, 25.0, 25.0);
      m.voltage_v[1] *= factor;
      observer.step(m);
      EXPECT_GE(observer.estimate().resistance_ohm[1], 0.45 / 2.5) << factor;
      EXPECT_LE(observer.estimate().resistance_ohm[1], 0.45 * 2.5) << factor;
    }
    EXPECT_EQ(observer.innovations(1).resistance_known, factor > 0.0) << factor;
  }
}

// A saved temperature that contradicts the thermistor gives no information about the other
// windings.
TEST(ThermalObserver, AStartThatIsKnownToAKelvinMakesAReferenceAndNoOther) {
  for (const double deviation_k : {0.3, 5.0}) {
    ThermalStart start = known(60.0);
    start.deviation_k = deviation_k;
    ThermalObserver observer(CoilModel{}, ThermalModel{}, start);
    for (int tick = 0; tick < 1000; ++tick) observer.step(measurement(1, 10.0, 60.0, 60.0));
    EXPECT_EQ(observer.winding(1).referenced(), deviation_k < 1.0) << deviation_k;
  }
}

TEST(ThermalObserver, AWarmThermistorIsNeverCappedWhileTheEstimateIsUnknown) {
  ThermalStart start;
  start.nodes = {{68.0, 68.0, 68.0}, 68.0};
  ThermalObserver observer(CoilModel{}, ThermalModel{}, start);
  observer.step(quiet(68.0));
  EXPECT_GE(observer.estimate().hottest_c, 68.0);
  ThermalObserver cold;
  for (int tick = 0; tick < 100; ++tick) cold.step(quiet(68.0));
  EXPECT_TRUE(cold.settling());
  EXPECT_GE(cold.estimate().hottest_c, 68.0);
  EXPECT_GE(cold.estimate().upper_c[0], 68.0);
}

TEST(ThermalObserver, ALooseThermistorCoolsItsWindingOnlySlowly) {
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(60.0));
  ThermalObserver without = observer;
  for (int tick = 0; tick < 10'000; ++tick) {
    observer.step(quiet(25.0));
    without.step(quiet(without.filter().thermistor_c(0)));
  }
  EXPECT_GT(observer.estimate().nodes.winding_c[0], without.estimate().nodes.winding_c[0] - 0.5);
}

TEST(ThermalObserver, EstimatesAnAmbientThatWasInitiallyWrong) {
  Plant plant(PlantParameters{}, 31.0);
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(25.0));
  for (int step = 0; step < 3 * 3600 * 50; ++step) {
    plant.step_thermal({}, 0.0, 20e-3);
    observer.step(quiet(plant.sensor_c()), 20e-3);
  }
  EXPECT_NEAR(observer.estimate().ambient_c, 31.0, 1.0);
  EXPECT_NEAR(observer.estimate().nodes.core_c, 31.0, 1.0);
}

TEST(ThermalObserver, AtRestWithFiveAmpereCoreAndAmbientStayRight) {
  ThermalLoop loop(PlantParameters{}, 25.0);
  for (int step = 0; step < 3600 * 50; ++step) loop.coarse_tick({0, 0, 5});
  EXPECT_NEAR(loop.observer.estimate().nodes.core_c, loop.plant.heat().core_c, 0.5);
  EXPECT_NEAR(loop.observer.estimate().ambient_c, 25.0, 0.5);
}

/// Ten minutes of random currents on a random ball: the largest error of a winding that has been
/// driven above 1.5 A for a second, and the largest excess of any winding over its bound.
struct Errors {
  double worst_k = 0.0;
  double above_bound_k = -kInfinity;
};

Errors observe_random_ball(std::uint64_t seed) {
  RandomStream random(seed);
  const PlantParameters real = random_plant(random.bits());
  ThermalLoop loop(real, random.uniform(18.0, 32.0), device_file_of(real));
  Errors errors;
  std::array<double, kCoils> driven_s{};
  Vec3 requested;
  double until_s = 0.0;
  for (int step = 0; step < 600 * 50; ++step) {
    if (step * 20e-3 >= until_s) {
      until_s += random.uniform(0.5, 30.0);
      requested = {random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-10, 10)};
      for (int coil = 0; coil < kCoils; ++coil)
        if (random.uniform(0, 1) < 0.4) requested[coil] = 0.0;
    }
    loop.coarse_tick(requested);
    for (int coil = 0; coil < kCoils; ++coil) {
      const auto i = static_cast<std::size_t>(coil);
      driven_s[i] = std::abs(loop.driven[coil]) > 1.5 ? driven_s[i] + 20e-3 : 0.0;
      const ThermalEstimate& estimate = loop.observer.estimate();
      const double real_c = loop.plant.heat().winding_c[i];
      if (driven_s[i] > 1.0)
        errors.worst_k = std::max(errors.worst_k, std::abs(estimate.nodes.winding_c[i] - real_c));
      errors.above_bound_k = std::max(errors.above_bound_k, real_c - estimate.upper_c[i]);
    }
  }
  return errors;
}

RC_GTEST_PROP(ThermalObserver, ItsBoundHoldsOnAnyBall, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const Errors errors = observe_random_ball(seed);
  RC_ASSERT(errors.worst_k < 2.5);
  RC_ASSERT(errors.above_bound_k < 0.0);
}

}  // namespace
}  // namespace hedgehog::model
