// SPDX-License-Identifier: MIT
// Criterion of `hedgehogctl calibrate` for a ball at a uniform temperature.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "clients/ctl/calibrate/calibration.h"
#include "clients/ctl/calibrate/rest_check.h"
#include "model/thermal/plant.h"

namespace hedgehog::client {
namespace {

using testing::HasSubstr;

const model::ThermalModel kThermal;

protocol::TemperatureStatus all_at(double celsius) {
  protocol::TemperatureStatus t;
  t.sensor = t.model = t.core = celsius;
  t.upper = celsius + 1.4;
  t.coils.fill(celsius);
  return t;
}

TEST(Rest, IsOneTemperatureWithinTwoKelvin) {
  EXPECT_FALSE(rest_deviation(all_at(25.0), kThermal).any());
  protocol::TemperatureStatus t = all_at(25.0);
  t.coils[1] = 26.9;
  EXPECT_FALSE(rest_deviation(t, kThermal).any());
  t.coils[1] = 27.1;
  EXPECT_EQ(rest_deviation(t, kThermal).what, "winding y is 2.1 K warmer than the thermometer");
  t.coils[1] = 22.5;
  EXPECT_EQ(rest_deviation(t, kThermal).what, "winding y is 2.5 K cooler than the thermometer");
  t = all_at(25.0);
  t.core = 28.0;
  EXPECT_EQ(rest_deviation(t, kThermal).what, "the core is 3.0 K warmer than the thermometer");
}

TEST(Rest, NeedsACertainEstimate) {
  protocol::TemperatureStatus t = all_at(25.0);
  t.upper = 28.5;
  EXPECT_THAT(rest_deviation(t, kThermal).what,
              HasSubstr("the thermal estimate has not converged"));
  EXPECT_EQ(rest_deviation(t, kThermal).wait_s, 180.0);
  t.upper = t.model = std::nullopt;
  EXPECT_THAT(rest_deviation(t, kThermal).what, HasSubstr("not known yet"));
}

TEST(Rest, ThreeThermistorsMustAgreeWithinTheirTolerance) {
  protocol::TemperatureStatus t = all_at(25.0);
  t.sensors = {24.1, 25.0, 25.9};
  EXPECT_FALSE(rest_deviation(t, kThermal).any());
  EXPECT_DOUBLE_EQ(reference_c(t), 25.0);
  t.sensors = {23.5, 25.0, 28.0};
  EXPECT_EQ(rest_deviation(t, kThermal).what, "the thermometers of the windings are 4.5 K apart");
}

RC_GTEST_PROP(Rest, IsReachedAfterTheReportedWait, ()) {
  model::PlantParameters ball;
  const auto off = [](double& value) { value *= 1.0 + *rc::gen::inRange(-15, 16) / 100.0; };
  for (double& value : ball.winding_j_k) off(value);
  for (double& value : ball.winding_to_core_k_w) off(value);
  off(ball.core_j_k);
  model::Plant plant(ball, 22.0);
  const double core_c = *rc::gen::inRange(25, 60);
  const double hot_c = core_c + *rc::gen::inRange(3, 15);
  plant.set_heat({{core_c, hot_c, core_c}, core_c});
  protocol::TemperatureStatus t = all_at(core_c);
  t.coils[1] = hot_c;
  const RestDeviation deviation = rest_deviation(t, kThermal);
  RC_ASSERT(deviation.any());
  RC_ASSERT(deviation.wait_s < 3600.0);
  bool fan = hot_c > 35.0;
  for (double s = 0.0; s < deviation.wait_s; s += 0.1) {
    fan = plant.hottest_winding_c() > (fan ? 35.0 : 40.0);
    plant.step_thermal({}, fan ? 1.0 : 0.0, 0.1);
  }
  const auto& now = plant.heat();
  RC_ASSERT(plant.hottest_winding_c() - now.core_c < kMaxApartK);
}

TEST(Drift, AWarmWindingIsDetectedByItsResistance) {
  const WindingMeasurement first{100.0, 25.0, {0.45, 0.46, 0.44}};
  WindingMeasurement second{140.0, 25.0, {0.45, 0.46, 0.44}};
  EXPECT_FALSE(drift_of(first, second).any());
  second.resistance_ohm[1] *= 1.0 - 2.0 * model::kCopperPerKelvin;
  EXPECT_THAT(drift_of(first, second).what,
              HasSubstr("winding y has cooled by 2.0 K against the thermometer within 40 s"));
  EXPECT_NEAR(drift_of(first, second).apart_k, 5.3, 0.1) << "as far as it may have been";
  second.error.fill(0.003);
  EXPECT_FALSE(drift_of(first, second).any()) << "within the noise of the look";
  second.error.fill(0.0);
  // The thermometer and all resistances change together: the ball only cools.
  const double cooler = 1.0 - 2.0 * model::kCopperPerKelvin;
  second = {140.0, 23.0, {0.45 * cooler, 0.46 * cooler, 0.44 * cooler}};
  EXPECT_FALSE(drift_of(first, second).any());
  second.resistance_ohm[0] = 0.45;
  EXPECT_THAT(drift_of(first, second).what, HasSubstr("winding x has warmed by 2.0 K"));
}

TEST(Drift, MinutesAreRoundedUp) {
  EXPECT_EQ(minutes_text(5.0), "1 minute");
  EXPECT_EQ(minutes_text(61.0), "2 minutes");
}

TEST(ResistanceUncertainty, GrowsWithTheToleranceOfTheThermometer) {
  Calibration found;
  found.resistance_share = 0.01;
  EXPECT_DOUBLE_EQ(resistance_uncertainty(found), 0.01);
  found.resistance_share = 0.03;
  found.unrest = "winding y is warm";
  found.apart_k = 10.0;
  EXPECT_NEAR(resistance_uncertainty(found), 0.0693, 1e-4);
  found.apart_k = 100.0;
  EXPECT_DOUBLE_EQ(resistance_uncertainty(found), 0.2) << "the most that a device file takes";
}

}  // namespace
}  // namespace hedgehog::client
