// SPDX-License-Identifier: MIT
// The start and the measurements of the observer: what it takes from them, and what it ignores.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/model/non_finite.h"
#include "tests/model/thermal_measurements.h"

namespace hedgehog::model {
namespace {

TEST(ThermalObserver, WithoutASavedAmbientItIsTheCoolestNodeOfACoolBall) {
  const auto ambient_c = [](const ThermalState& nodes) {
    ThermalStart start;
    start.nodes = nodes;
    return ThermalObserver(CoilModel{}, ThermalModel{}, start).estimate().ambient_c;
  };
  EXPECT_EQ(ambient_c({{30.0, 31.0, 32.0}, 33.0}), 30.0);
  EXPECT_EQ(ambient_c({{33.0, 30.0, 32.0}, 33.0}), 30.0);
  EXPECT_EQ(ambient_c({{33.0, 31.0, 30.0}, 33.0}), 30.0);
  EXPECT_EQ(ambient_c({{60.0, 60.0, 60.0}, 34.0}), 34.0);
  EXPECT_EQ(ambient_c({{60.0, 60.0, 60.0}, 36.0}), 25.0) << "warm throughout";
}

TEST(ThermalObserver, ItsWindingsAreThoseOfTheDeviceFile) {
  CoilModel coils;
  coils.r25_ohm = {0.40, 0.50, 0.60};
  const ThermalObserver observer(coils, ThermalModel{}, known(25.0));
  for (int coil = 0; coil < kCoils; ++coil)
    EXPECT_EQ(observer.winding(coil).r25_ohm(), coils.r25_ohm[static_cast<std::size_t>(coil)]);
  EXPECT_FALSE(observer.settling()) << "a known start";
}

TEST(ThermalObserver, UntilTheFirstReadingTheThermistorIsAtTheStart) {
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(60.0));
  EXPECT_EQ(observer.estimate().sensor_lead_c, 60.0);
  observer.step(ThermalMeasurement{});
  EXPECT_EQ(observer.estimate().sensor_lead_c, 60.0);
}

TEST(ThermalObserver, CurrentsAboveAHundredAmpereCountAsNotMeasured) {
  const auto bound_c = [](double current_a) {
    ThermalObserver observer(CoilModel{}, ThermalModel{}, known(25.0));
    for (int tick = 0; tick < 200; ++tick) observer.step(measurement(1, 5.0, 25.0, 25.0));
    for (int tick = 0; tick < 200; ++tick) observer.step(measurement(1, current_a, 25.0, 25.0));
    return observer.estimate().upper_c[1];
  };
  EXPECT_EQ(bound_c(101.0), bound_c(kNan));
  EXPECT_GT(bound_c(99.0), bound_c(kNan) + 10.0);
}

TEST(ThermalObserver, TheLeadOfAThermistorExceedsItsWindingByFourKelvinAtMost) {
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(25.0));
  double sensor_c = 25.0;
  for (int tick = 0; tick < 900; ++tick) observer.step(quiet(sensor_c += 4e-3));
  const double winding_c = observer.filter().winding_c(0);
  ASSERT_LT(sensor_c + 0.5, winding_c + 4.0);
  ASSERT_GT(observer.estimate().sensor_lead_c, winding_c + 4.0);
  EXPECT_DOUBLE_EQ(observer.estimate().hottest_c, winding_c + 4.0);
}

TEST(ThermalObserver, ASupplyReadingThatFallsRaisesTheBoundByWhatVOverIMayReadTooCool) {
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(25.0));
  ThermalMeasurement m = measurement(1, 10.0, 25.0, 25.0);
  m.supply_v = 12.0;
  for (int tick = 0; tick < 1000; ++tick) observer.step(m);
  ASSERT_TRUE(observer.winding(1).referenced());
  const double drawn_w = dot(m.voltage_v, m.current_a);
  const double open_v = 12.0 + 0.02 * drawn_w / 12.0;
  m.supply_v = 11.0;
  const double fallen = 1.0 - (11.0 + 0.02 * drawn_w / 11.0) / open_v;
  const WindingThermometer& winding = observer.winding(1);
  for (int tick = 1; tick <= 900; ++tick) {
    observer.step(m);
    if (tick % 300 != 0) continue;
    const double smooth = fallen * (1.0 - std::exp(-tick / 300.0));
    const double by_resistance_c = winding.celsius() - winding.bias_k() - winding.noise_k();
    EXPECT_NEAR(observer.estimate().upper_c[1],
                by_resistance_c + (smooth - 0.012) * kelvins_per_share(Celsius(25.0)) + 0.5 +
                    observer.fall(1).margin_k(),
                0.1);
  }
}

TEST(ThermalObserver, TheFilterIsUpdatedTenTimesASecondWhateverTheStep) {
  for (const auto& [dt_s, steps] : {std::pair{1e-3, 100}, {10e-3, 10}, {20e-3, 5}}) {
    ThermalObserver observer;
    for (int step = 1; step <= 3 * steps; ++step) {
      observer.step(quiet(25.0), dt_s);
      EXPECT_EQ(observer.window_ended(), step % steps == 0) << dt_s << " s, step " << step;
    }
  }
}

TEST(ThermalObserver, NumbersThatAreNotFiniteLeaveTheEstimateFinite) {
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(45.0));
  for (int tick = 0; tick < 200; ++tick) observer.step(measurement(0, 5.0, 45.0, 44.0));
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e200}) {
    ThermalMeasurement m = measurement(0, 5.0, 45.0, 44.0);
    m.current_a.x = bad;
    observer.step(m);
    m = measurement(0, 5.0, 45.0, 44.0);
    m.voltage_v.y = bad == 1e200 ? kNan : bad;
    observer.step(m);
    m = measurement(0, 5.0, 45.0, 44.0);
    m.thermistors.celsius[0] = bad == 1e200 ? kNan : bad;
    observer.step(m);
  }
  for (int tick = 0; tick < 200; ++tick) observer.step(measurement(0, 5.0, 45.0, 44.0));
  EXPECT_NEAR(observer.estimate().nodes.winding_c[0], 45.0, 0.5);
  EXPECT_TRUE(std::isfinite(observer.estimate().hottest_c));
  EXPECT_TRUE(std::isfinite(observer.estimate().ambient_c));
}

}  // namespace
}  // namespace hedgehog::model
