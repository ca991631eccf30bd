// SPDX-License-Identifier: MIT
// The simulated ball against the reference values of its parameters (model/thermal-model.md) and
// against closed forms.
#include "model/thermal/plant.h"
#include "model/magnets/ball_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace hedgehog::model {
namespace {

static_assert(std::is_trivially_copyable_v<Plant>);
static_assert(std::is_trivially_copyable_v<PlantParameters>);

PlantInputs driven(const Vec3& voltage_v) {
  PlantInputs inputs;
  inputs.bridge.fill(BridgeState::kDriven);
  inputs.voltage_v = voltage_v;
  inputs.fan_duty = 1.0;
  return inputs;
}

/// Seconds from 25 to 70 C with `current_a` held in the windings, no limiter, fan running.
double seconds_to_70(const Vec3& current_a) {
  Plant plant(PlantParameters{}, 25.0);
  for (int tick = 1; tick < 200'000; ++tick) {
    Vec3 hold;
    for (int coil = 0; coil < kCoils; ++coil)
      hold[coil] = current_a[coil] * plant.resistance_ohm(coil);
    plant.step(driven(hold), 1e-3);
    if (plant.hottest_winding_c() >= 70.0) return tick * 1e-3;
  }
  return -1.0;
}

TEST(Plant, FifteenAmpereAlongOneCoilReach70InHalfAMinute) {
  EXPECT_NEAR(seconds_to_70({15, 0, 0}), 29.6, 0.5);
  EXPECT_NEAR(seconds_to_70({0, 15, 0}), 29.6, 0.5);
  EXPECT_NEAR(seconds_to_70({0, 0, -15}), 29.6, 0.5);
}

// 15 A along a winding extend the pins in the winding's direction as far as the ball's own slope
// predicts (reference: physics.md section 6; 0.51 mm on the ball of 86 pins instead of 0.52).
TEST(Plant, ItsPinsFollowItsTrueCurrents) {
  PlantParameters turned;
  turned.coil_matrix = {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}};
  // From the thesis' simulation, for a pin at its rest.
  turned.force_slope_n_a = 0.02533;
  Plant plant(turned, 25.0);
  const auto pins = [&] { return plant.pins(thesis_ball().array, thesis_ball().curves); };
  EXPECT_EQ(pins().extension_mm, std::vector<double>(86, 0.0));
  for (int tick = 0; tick < 100; ++tick) plant.step(driven({0, 15 * 0.45, 0}), 1e-3);
  const double current_a = plant.current_a().y;
  EXPECT_NEAR(current_a, 15.0, 0.1);
  const NearestPin left = nearest_pin(thesis_ball().array, {0, 1, 0});
  const auto at = static_cast<std::size_t>(left.id);
  EXPECT_NEAR(pins().force_n[at], current_a * turned.force_slope_n_a * left.cosine, 2e-4);
  EXPECT_NEAR(pins().extension_mm[at], 0.51 * left.cosine, 0.01);

  Plant up(turned, 25.0);
  for (int tick = 0; tick < 100; ++tick) up.step(driven({15 * 0.45, 0, 0}), 1e-3);
  const std::vector<double> out = up.pins(thesis_ball().array, thesis_ball().curves).extension_mm;
  EXPECT_GT(out[1], 0.4) << "winding x points up in this ball";
  EXPECT_LT(*std::min_element(out.begin(), out.end()), -0.2);
}

TEST(Plant, FifteenAmpereSharedByThreeTake101Seconds) {
  const double each = 15.0 / std::sqrt(3.0);
  EXPECT_NEAR(seconds_to_70({each, each, each}), 101.0, 2.0);
}

TEST(Plant, CoarseThermalStepAgreesWithTheFineOne) {
  Plant fine(PlantParameters{}, 25.0);
  Plant coarse(PlantParameters{}, 25.0);
  for (int step = 0; step < 3000; ++step) {
    for (int tick = 0; tick < 20; ++tick) fine.step_thermal({100, 16, 0}, 1.0, 1e-3);
    coarse.step_thermal({100, 16, 0}, 1.0, 20e-3);
  }
  EXPECT_GT(fine.heat().winding_c[0], 50.0);
  for (std::size_t i = 0; i < kCoils; ++i)
    EXPECT_NEAR(coarse.heat().winding_c[i], fine.heat().winding_c[i], 0.05);
  EXPECT_NEAR(coarse.heat().core_c, fine.heat().core_c, 0.05);
  EXPECT_NEAR(coarse.sensor_body_c(), fine.sensor_body_c(), 0.05);
}

TEST(Plant, CurrentFollowsLOverRExactlyWhateverTheStep) {
  Plant plant(PlantParameters{}, 25.0);
  for (int tick = 0; tick < 5; ++tick) plant.step(driven({4.5, 0, 0}), 1e-3);
  EXPECT_NEAR(plant.current_a().x, 10.0 * (1.0 - std::exp(-5e-3 * 0.45 / 1.5e-3)), 1e-3);
  Plant other(PlantParameters{}, 25.0);
  other.step(driven({4.5, 0, 0}), 5e-3);
  EXPECT_NEAR(other.current_a().x, plant.current_a().x, 1e-3);
}

TEST(Plant, MeanSquareIsTheIntegralOfTheCurrent) {
  Plant plant(PlantParameters{}, 25.0);
  plant.step(driven({12, -12, 3}), 1e-3);
  for (int coil = 0; coil < kCoils; ++coil) {
    const double settled = Vec3{12, -12, 3}[coil] / 0.45;
    double sum = 0.0;
    for (int part = 0; part < 10'000; ++part) {
      const double i = settled * (1.0 - std::exp(-(part + 0.5) * 1e-7 * 0.45 / 1.5e-3));
      sum += i * i * 1e-4;
    }
    EXPECT_NEAR(plant.mean_square_a2()[coil], sum, 1e-6 * (1.0 + sum));
  }
}

TEST(Plant, BrakeAndSleepEndTheCurrentWithinFiveTimeConstants) {
  for (const BridgeState bridge : {BridgeState::kDriven, BridgeState::kAsleep}) {
    Plant plant(PlantParameters{}, 25.0);
    for (int tick = 0; tick < 100; ++tick) plant.step(driven({6.75, -6.75, 0}), 1e-3);
    ASSERT_NEAR(plant.current_a().x, 15.0, 0.1);
    PlantInputs off;
    off.bridge.fill(bridge);
    for (int tick = 0; tick < 17; ++tick) plant.step(off, 1e-3);
    EXPECT_LT(norm(plant.current_a()), 0.15);
    EXPECT_LT(std::abs(plant.current_a().x), 0.1);
    if (bridge == BridgeState::kAsleep) EXPECT_EQ(plant.current_a(), Vec3{});
  }
}

TEST(Plant, ABrokenWindingCarriesNothing) {
  Plant plant(PlantParameters{}, 25.0);
  PlantInputs inputs = driven({6, 6, 6});
  inputs.bridge[1] = BridgeState::kOpen;
  for (int tick = 0; tick < 50; ++tick) plant.step(inputs, 1e-3);
  EXPECT_EQ(plant.current_a().y, 0.0);
  EXPECT_GT(plant.current_a().x, 10.0);
}

TEST(Plant, FanSpinsUpAndRunsOut) {
  Plant plant(PlantParameters{}, 25.0);
  PlantInputs inputs;
  inputs.fan_duty = 1.0;
  for (int tick = 0; tick < 1000; ++tick) plant.step(inputs, 1e-3);
  EXPECT_NEAR(plant.fan_rpm() / plant.parameters().fan_full_rpm, 0.632, 0.01);
  for (int tick = 0; tick < 4000; ++tick) plant.step(inputs, 1e-3);
  EXPECT_GT(plant.fan_rpm(), 0.98 * plant.parameters().fan_full_rpm);
  inputs.fan_stopped = true;
  for (int tick = 0; tick < 5000; ++tick) plant.step(inputs, 1e-3);
  EXPECT_LT(plant.fan_rpm(), 0.02 * plant.parameters().fan_full_rpm);
}

TEST(Plant, ThermistorLagsAndItsNoiseIsTheSameEveryTime) {
  PlantParameters parameters;
  parameters.sensor_noise_k = 0.15;
  parameters.seed = 77;
  Plant a(parameters, 25.0);
  Plant b(parameters, 25.0);
  double sum = 0.0;
  double squares = 0.0;
  for (int tick = 0; tick < 20'000; ++tick) {
    a.step(PlantInputs{}, 1e-3);
    b.step(PlantInputs{}, 1e-3);
    ASSERT_EQ(a.sensor_c(), b.sensor_c());
    const double noise = a.sensor_c() - a.sensor_body_c();
    sum += noise;
    squares += noise * noise;
  }
  EXPECT_NEAR(sum / 20'000, 0.0, 0.005);
  EXPECT_NEAR(std::sqrt(squares / 20'000), 0.15, 0.005);

  ThermalState warm;
  warm.winding_c[0] = 60.0;
  Plant lagging(PlantParameters{}, 25.0);
  lagging.set_heat(warm);
  EXPECT_EQ(lagging.sensor_c(), 60.0);
}

}  // namespace
}  // namespace hedgehog::model
