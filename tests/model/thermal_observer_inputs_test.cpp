// SPDX-License-Identifier: MIT
// The start and the measurements of the observer: what it takes from them, and what it ignores.
#include <gtest/gtest.h>

#include <array>
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

/// A thermistor that warms by `rate_k_s`, and no current.
ThermalObserver warmed(double rate_k_s, int ticks) {
  ThermalObserver observer(CoilModel{}, ThermalModel{}, known(25.0));
  double sensor_c = 25.0;
  for (int tick = 0; tick < ticks; ++tick) observer.step(quiet(sensor_c += rate_k_s * 1e-3));
  return observer;
}

TEST(ThermalObserver, TheHottestIsTheThermistorsLeadAndItsTolerance) {
  const ThermalObserver observer = warmed(2.0, 1000);
  const double lead_c = observer.estimate().sensor_lead_c;
  ASSERT_LT(lead_c, observer.filter().winding_c(0) + 3.0);
  EXPECT_DOUBLE_EQ(observer.estimate().hottest_c, lead_c + 0.5);
}

TEST(ThermalObserver, TheLeadOfAThermistorExceedsItsWindingByFourKelvinAtMost) {
  const ThermalObserver observer = warmed(4.0, 900);
  const double winding_c = observer.filter().winding_c(0);
  ASSERT_GT(observer.estimate().sensor_lead_c, winding_c + 4.0);
  EXPECT_DOUBLE_EQ(observer.estimate().hottest_c, winding_c + 4.0);
}

/// A ball that plays 10 A along winding `coil` at 12 V, with the thermistors `valid`.
struct Supplied {
  Supplied(int coil, int sensor_winding, const std::array<bool, kCoils>& valid)
      : m(measurement(coil, 10.0, 25.0, 25.0)) {
    ThermalModel thermal;
    thermal.sensor_winding = sensor_winding;
    observer = ThermalObserver(CoilModel{}, thermal, known(25.0));
    m.thermistors.valid = valid;
    m.supply_v = 12.0;
    for (int tick = 0; tick < 1000; ++tick) observer.step(m);
  }
  ThermalMeasurement m;
  ThermalObserver observer;
};

TEST(ThermalObserver, ASupplyReadingThatFallsRaisesTheBoundByWhatVOverIMayReadTooCool) {
  for (int coil = 0; coil < kCoils; ++coil) {
    const int other = (coil + 1) % kCoils;
    std::array<bool, kCoils> valid{};
    valid[static_cast<std::size_t>(other)] = true;
    Supplied ball(coil, other, valid);
    ThermalMeasurement& m = ball.m;
    const double drawn_w = dot(m.voltage_v, m.current_a);
    const double open_v = 12.0 + 0.02 * drawn_w / 12.0;
    m.supply_v = 11.0;
    const double fallen = 1.0 - (11.0 + 0.02 * drawn_w / 11.0) / open_v;
    const WindingThermometer& winding = ball.observer.winding(coil);
    ASSERT_TRUE(winding.referenced());
    for (int tick = 1; tick <= 900; ++tick) {
      ball.observer.step(m);
      if (tick % 300 != 0) continue;
      const double smooth = fallen * (1.0 - std::exp(-tick / 300.0));
      const double by_resistance_c = winding.celsius() - winding.bias_k() - winding.noise_k();
      EXPECT_NEAR(ball.observer.estimate().upper_c[static_cast<std::size_t>(coil)],
                  by_resistance_c + (smooth - 0.012) * kelvins_per_share(Celsius(25.0)) + 0.5 +
                      ball.observer.fall(coil).margin_k(),
                  0.1);
    }
  }
}

TEST(ThermalObserver, ASupplyReadingThatFallsMattersLittleBesideItsOwnThermistor) {
  Supplied ball(1, 0, {true, true, true});
  ball.m.supply_v = 11.0;
  for (int tick = 0; tick < 900; ++tick) ball.observer.step(ball.m);
  EXPECT_LT(ball.observer.estimate().upper_c[1], 32.0);
}

/// By how much the bound rises when the supply reads 11 V, after 0.1 s of `between`.
double rise_after_k(const ThermalMeasurement& between) {
  Supplied ball(1, 0, {true, false, false});
  const auto step = [&](const ThermalMeasurement& m, int ticks) {
    for (int tick = 0; tick < ticks; ++tick) ball.observer.step(m);
    return ball.observer.estimate().upper_c[1];
  };
  step(between, 100);
  const double before_c = step(ball.m, 300);
  ball.m.supply_v = 11.0;
  return step(ball.m, 900) - before_c;
}

TEST(ThermalObserver, IgnoresTheSupplyBesideWhatIsNotMeasured) {
  ThermalMeasurement as_before = measurement(1, 10.0, 25.0, 25.0);
  as_before.supply_v = 12.0;
  const double rise_k = rise_after_k(as_before);
  ASSERT_GT(rise_k, 10.0);
  for (const double bad : {kNan, kInfinity}) {
    ThermalMeasurement m = as_before;
    m.voltage_v[0] = bad;
    EXPECT_NEAR(rise_after_k(m), rise_k, 0.5);
    m = as_before;
    m.current_a[0] = bad;
    EXPECT_NEAR(rise_after_k(m), rise_k, 0.5);
  }
  for (const double bad : {kNan, 0.0, -1.0}) {
    ThermalMeasurement m = as_before;
    m.supply_v = bad;
    EXPECT_NEAR(rise_after_k(m), rise_k, 0.5);
  }
  ThermalMeasurement m = as_before;
  m.electrical_valid = false;
  m.supply_v = 6.0;
  EXPECT_NEAR(rise_after_k(m), rise_k, 0.5) << "V/I remains referenced at 12 V";
}

TEST(ThermalObserver, ACurrentInTheOtherDirectionIsMeasuredAsWell) {
  const auto observed = [](double sign) {
    ThermalObserver observer(CoilModel{}, ThermalModel{}, known(25.0));
    for (int tick = 0; tick < 5000; ++tick) {
      // A small ripple, so that the derivatives of two windows differ.
      const double current_a = sign * (5.0 + 0.2 * std::sin(0.07 * tick));
      ThermalMeasurement m = measurement(1, current_a, 26.0, 25.0);
      m.accuracy = kInLineAccuracy;
      observer.step(m);
    }
    return observer.estimate();
  };
  const ThermalEstimate there = observed(1.0);
  const ThermalEstimate back = observed(-1.0);
  EXPECT_NEAR(there.nodes.winding_c[1], back.nodes.winding_c[1], 1e-9);
  EXPECT_NEAR(there.upper_c[1], back.upper_c[1], 1e-9);
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
