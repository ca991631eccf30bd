// SPDX-License-Identifier: MIT
// The identification on recorded heating and cooling of balls drawn from the family, with the
// errors of their electronics.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "model/identification/thermal_fit.h"
#include "tests/rig/heated_ball.h"

namespace hedgehog::model {
namespace {

constexpr std::array<double, 3> kR25{0.45, 0.45, 0.45};

struct Drawn {
  PlantParameters plant;
  Readings readings;
  double ambient_c = 25.0;
};

/// R25 as measured: within 1 %, gain errors included.
Drawn draw(std::uint64_t seed) {
  RandomStream random(seed);
  Drawn ball;
  const auto off = [&](double& value, double share) {
    value *= random.uniform(1.0 - share, 1.0 + share);
  };
  for (double& value : ball.plant.winding_j_k) off(value, 0.2);
  for (double& value : ball.plant.winding_to_core_k_w) off(value, 0.2);
  off(ball.plant.core_j_k, 0.2);
  off(ball.plant.core_to_ambient_fan_k_w, 0.2);
  off(ball.plant.core_to_ambient_still_k_w, 0.2);
  for (double& value : ball.plant.r25_ohm) off(value, 0.03);
  for (double& value : ball.readings.current_gain) off(value, 0.02);
  for (double& value : ball.readings.current_offset_a) value = random.uniform(-0.02, 0.02);
  off(ball.readings.supply_gain, 0.02);
  ball.readings.thermistor_offset_k = random.uniform(-1.0, 1.0);
  ball.plant.sensor_lag_s = random.uniform(1.0, 3.0);
  ball.plant.sensor_winding = static_cast<int>(seed % 3);
  ball.ambient_c = random.uniform(18.0, 32.0);
  return ball;
}

std::array<double, 3> shown_r25(const Drawn& ball) {
  std::array<double, 3> ohm = ball.plant.r25_ohm;
  for (std::size_t i = 0; i < 3; ++i)
    ohm[i] *= ball.readings.supply_gain / ball.readings.current_gain[i];
  return ohm;
}

struct Deviation {
  const char* name;
  double off;
  double claimed;
};

/// Deviation of every constant from the ball's, with power as the board measures it.
std::vector<Deviation> deviations(const ThermalFound& found, const Drawn& ball) {
  std::vector<Deviation> all;
  double mean_gain = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double gain = ball.readings.power_gain(i);
    mean_gain += gain / 3.0;
    all.push_back({"winding_j_k",
                   found.thermal.winding_j_k[i] / ball.plant.winding_j_k[i] / gain - 1,
                   found.uncertainty});
    all.push_back(
        {"winding_to_core_k_w",
         found.thermal.winding_to_core_k_w[i] / ball.plant.winding_to_core_k_w[i] * gain - 1,
         found.uncertainty});
  }
  all.push_back({"core_j_k", found.thermal.core_j_k / ball.plant.core_j_k / mean_gain - 1,
                 found.uncertainty});
  all.push_back(
      {"core_to_room_fan_k_w",
       found.thermal.core_to_ambient_fan_k_w / ball.plant.core_to_ambient_fan_k_w * mean_gain - 1,
       found.uncertainty});
  all.push_back(
      {"core_to_room_still_k_w",
       found.thermal.core_to_ambient_still_k_w / ball.plant.core_to_ambient_still_k_w * mean_gain -
           1,
       found.still_uncertainty});
  return all;
}

HeatRun heat(HeatedBall& ball, const std::vector<HeatingStep>& plan, std::size_t from,
             std::size_t to) {
  HeatRun run;
  run.began_at_rest = from == 0;
  for (std::size_t k = from; k < to; ++k) run.samples.push_back(ball.step(plan[k]));
  return run;
}

TEST(ThermalFit, FindsTheNetworkOfTheFamilysBalls) {
  constexpr int kBalls = 20;
  const auto plan = heating_plan();
  EXPECT_NEAR(duration_s(plan), 1800.0, 120.0);
  int constants = 0;
  int within = 0;
  int close = 0;
  for (int seed = 1; seed <= kBalls; ++seed) {
    const Drawn drawn = draw(static_cast<std::uint64_t>(seed));
    HeatedBall ball(drawn.plant, drawn.readings, drawn.ambient_c, static_cast<std::uint64_t>(seed));
    const auto found = fit_thermal({heat(ball, plan, 0, plan.size())}, shown_r25(drawn), {});
    ASSERT_TRUE(found) << seed;
    EXPECT_EQ(found->thermal.sensor_winding, drawn.plant.sensor_winding) << seed;
    EXPECT_TRUE(found->sensor_certain) << seed;
    EXPECT_LT(found->uncertainty, 0.1) << seed;
    EXPECT_LT(ball.hottest_c(), 70.0) << seed;
    for (const Deviation& one : deviations(*found, drawn)) {
      ++constants;
      within += std::abs(one.off) <= one.claimed ? 1 : 0;
      close += std::abs(one.off) <= 0.05 ? 1 : 0;
    }
  }
  EXPECT_GE(within, 0.95 * constants) << within << " of " << constants;
  EXPECT_GE(close, 0.9 * constants) << close << " of " << constants;
}

TEST(ThermalFit, AnInterruptedRunIsFittedWithTheRest) {
  const auto plan = heating_plan();
  const Drawn drawn = draw(4);
  HeatedBall ball(drawn.plant, drawn.readings, drawn.ambient_c, 4);
  const HeatRun first = heat(ball, plan, 0, plan.size() / 2);
  ball.rest(600.0);
  const HeatRun second = heat(ball, plan, plan.size() / 2, plan.size());
  const auto found = fit_thermal({first, second}, shown_r25(drawn), {});
  ASSERT_TRUE(found);
  for (const Deviation& one : deviations(*found, drawn))
    EXPECT_LE(std::abs(one.off), one.claimed) << one.name;
}

TEST(ThermalFit, TooLittleDeterminesNothing) {
  const auto plan = heating_plan();
  const Drawn drawn = draw(5);
  HeatedBall ball(drawn.plant, drawn.readings, drawn.ambient_c, 5);
  EXPECT_FALSE(fit_thermal({}, kR25, {}));
  EXPECT_FALSE(fit_thermal({HeatRun{}}, kR25, {}));
  EXPECT_FALSE(fit_thermal({heat(ball, plan, 0, plan.size() / 5)}, kR25, {}));
}

TEST(ThermalFit, DataThatFitsNoFourNodesIsRefused) {
  const auto plan = heating_plan();
  const Drawn drawn = draw(6);
  HeatedBall ball(drawn.plant, drawn.readings, drawn.ambient_c, 6);
  HeatRun run = heat(ball, plan, 0, plan.size());
  for (std::size_t k = 0; k < run.samples.size(); ++k)
    *run.samples[k].sensor_c += k % 60 < 30 ? 3.0 : 0.0;
  EXPECT_FALSE(fit_thermal({run}, shown_r25(drawn), {}));
}

}  // namespace
}  // namespace hedgehog::model
