// SPDX-License-Identifier: MIT
// The energy floor is below the temperature of every ball of the family, but not far below.
#include "model/estimate/energy_floor.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>

#include "model/thermal/thermal_decay.h"
#include "tests/model/thermal_loop.h"

namespace hedgehog::model {
namespace {

/// Temperature of the winding driven with `current_a` for `seconds`, minus its floor.
double above_floor_k(const PlantParameters& real, double current_a, double seconds,
                     bool thermistors) {
  Plant plant(real, 25.0);
  const ThermalState start{{25.0, 25.0, 25.0}, 25.0};
  EnergyFloor floor(ThermalModel{}, 0.2, start, 25.0);
  double min_k = 100.0;
  for (double t = 0.0; t < seconds; t += 0.1) {
    const double loss_w = plant.resistance_ohm(1) * current_a * current_a;
    for (int i = 0; i < 5; ++i) plant.step_thermal({0, current_a * current_a, 0}, 0.0, 0.02);
    ThermistorReadings readings;
    for (int coil = 0; coil < kCoils; ++coil) {
      const auto i = static_cast<std::size_t>(coil);
      readings.celsius[i] = plant.thermistor_c(coil);
      readings.valid[i] = thermistors || coil == real.sensor_winding;
    }
    floor.step({0, loss_w, 0}, false, readings, 0.1);
    min_k = std::min(min_k, plant.heat().winding_c[1] - floor.winding_c(1));
  }
  return min_k;
}

RC_GTEST_PROP(EnergyFloor, IsBelowEveryBallOfTheFamily, ()) {
  PlantParameters real = random_plant(*rc::gen::arbitrary<std::uint64_t>());
  const double current_a = *rc::gen::inRange(2, 16);
  RC_ASSERT(above_floor_k(real, current_a, 120.0, *rc::gen::arbitrary<bool>()) > -1.0);
}

TEST(EnergyFloor, IsAFewKelvinBelowAMatchingBall) {
  const ThermalState start{{25.0, 25.0, 25.0}, 25.0};
  Plant plant(PlantParameters{}, 25.0);
  EnergyFloor floor(ThermalModel{}, 0.2, start, 25.0);
  for (int step = 0; step < 200; ++step) {
    const double loss_w = plant.resistance_ohm(1) * 225.0;
    for (int i = 0; i < 5; ++i) plant.step_thermal({0, 225.0, 0}, 0.0, 0.02);
    floor.step({0, loss_w, 0}, false, {}, 0.1);
  }
  const double real_c = plant.heat().winding_c[1];
  ASSERT_GT(real_c, 50.0);
  EXPECT_LT(floor.winding_c(1), real_c);
  EXPECT_GT(floor.winding_c(1), real_c - 10.0);
}

constexpr ThermalState kSettled{{25.0, 25.0, 25.0}, 25.0};
constexpr double kWindow = 0.1;

/// Rise of winding 0 in the first window, K, of a ball of one temperature whose thermistors `valid`
/// show 6 K more.
double corrected_k(const std::array<bool, kCoils>& valid) {
  EnergyFloor floor(ThermalModel{}, 0.2, kSettled, 25.0);
  ThermistorReadings readings;
  readings.celsius.fill(31.0);
  readings.valid = valid;
  floor.step({}, false, readings, kWindow);
  return floor.winding_c(0) - 25.0;
}

TEST(EnergyFloor, FollowsASingleThermistorMoreSlowlyThanOneOfSeveral) {
  EXPECT_NEAR(corrected_k({true, false, false}), 6.0 * kWindow / 10.0, 1e-9);
  EXPECT_NEAR(corrected_k({true, true, false}), 6.0 * kWindow / 6.0, 1e-9);
  EXPECT_NEAR(corrected_k({true, true, true}), 6.0 * kWindow / 6.0, 1e-9);
  EXPECT_NEAR(corrected_k({false, true, true}), 0.0, 1e-9) << "its own thermistor only";
}

TEST(EnergyFloor, AThermistorQuickerThanAWindowShowsItsWinding) {
  ThermalModel quick;
  quick.winding_j_k.fill(5.0);
  quick.sensor_lag_s = kMinSensorLagS;
  const ThermalState hot{{60.0, 25.0, 25.0}, 25.0};
  EnergyFloor alone(quick, 0.2, hot, 25.0);
  EnergyFloor beside = alone;
  alone.step({}, false, {}, 2.0 * kWindow);
  ASSERT_LT(alone.winding_c(0), 59.0);
  ThermistorReadings readings;
  readings.celsius[0] = alone.winding_c(0);
  readings.valid[0] = true;
  beside.step({}, false, readings, 2.0 * kWindow);
  EXPECT_NEAR(beside.winding_c(0), alone.winding_c(0), 1e-9);
}

}  // namespace
}  // namespace hedgehog::model
