// SPDX-License-Identifier: MIT
// Cooling without current is exact. With all constants that a device file may contain, every
// integration step is stable: a node stays between its surrounding temperatures, and does not
// oscillate.
#include "model/thermal/thermal_decay.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/estimate/energy_floor.h"
#include "model/estimate/thermal_filter.h"
#include "model/thermal/plant.h"
#include "model/thermal/thermal_flow.h"

namespace hedgehog::model {
namespace {

constexpr double kAmbientC = 20.0;
constexpr double kRoundingK = 1e-9;

/// Uniform over the orders of magnitude from `min` to `max`.
double draw(double min, double max) {
  const double share = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 10'001)) / 10'000.0;
  return min * std::pow(max / min, share);
}

/// Any constants within the range of each key of a device file.
ThermalModel any_model() {
  ThermalModel model;
  for (double& value : model.winding_j_k) value = draw(1, 10'000);
  model.core_j_k = draw(1, 10'000);
  for (double& value : model.winding_to_core_k_w) value = draw(0.01, 100);
  model.core_to_ambient_fan_k_w = draw(0.01, 100);
  model.core_to_ambient_still_k_w = draw(0.01, 100);
  model.sensor_lag_s = draw(kMinSensorLagS, 10);
  return model;
}

bool is_accepted(const ThermalModel& model) {
  const NodeTimeConstants time = node_time_constants(model);
  return time.winding_s >= kMinTimeConstantS && time.core_s >= kMinTimeConstantS;
}

ThermalModel accepted_model() {
  ThermalModel model = any_model();
  while (!is_accepted(model)) model = any_model();
  return model;
}

ThermalState any_nodes() {
  const auto celsius = [] { return static_cast<double>(*rc::gen::inRange(20, 100)); };
  return {{celsius(), celsius(), celsius()}, celsius()};
}

double hottest_node(const ThermalState& nodes) {
  return std::max(hottest_winding(nodes), nodes.core_c);
}
double coolest_node(const ThermalState& nodes) {
  const auto& w = nodes.winding_c;
  return std::min({w[0], w[1], w[2], nodes.core_c});
}

/// `step` of an undriven ball: the hottest node never warms, none falls below ambient.
template <class Step>
void expect_settles(ThermalState nodes, int steps, Step step) {
  for (int i = 0; i < steps; ++i) {
    const ThermalState next = step(nodes);
    RC_ASSERT(hottest_node(next) <= hottest_node(nodes) + kRoundingK);
    RC_ASSERT(coolest_node(next) >= kAmbientC - kRoundingK);
    nodes = next;
  }
}

TEST(TimeConstants, OfTheWindingsTheShortest) {
  ThermalModel model;
  model.winding_j_k = {10.0, 20.0, 30.0};
  model.winding_to_core_k_w = {3.0, 1.0, 2.0};
  EXPECT_DOUBLE_EQ(node_time_constants(model).winding_s, 20.0);
  model.winding_to_core_k_w = {1.5, 1.0, 2.0};
  EXPECT_DOUBLE_EQ(node_time_constants(model).winding_s, 15.0);
  model.winding_to_core_k_w = {1.5, 1.0, 0.25};
  EXPECT_DOUBLE_EQ(node_time_constants(model).winding_s, 7.5);
}

TEST(TimeConstants, OfTheCoreWithTheBetterOfBothWaysToTheAmbient) {
  ThermalModel model;
  model.core_j_k = 12.0;
  model.winding_to_core_k_w = {1.0, 2.0, 4.0};
  model.core_to_ambient_fan_k_w = 4.0;
  model.core_to_ambient_still_k_w = 8.0;
  EXPECT_DOUBLE_EQ(node_time_constants(model).core_s, 6.0) << "12 J/K into 2 W/K";
  model.core_to_ambient_still_k_w = 0.2;
  EXPECT_DOUBLE_EQ(node_time_constants(model).core_s, 12.0 / 6.75);
}

TEST(Decay, CoolsAndNeverBelowTheAmbient) {
  const ThermalModel ball;
  const ThermalState hot{{50.0, 60.0, 55.0}, 45.0};
  const auto after_10_s = decayed(ball, hot, 25.0, 10.0);
  EXPECT_LT(after_10_s.winding_c[1], 60.0);
  EXPECT_GT(after_10_s.winding_c[1], 55.0);
  EXPECT_NEAR(decayed(ball, hot, 25.0, 3600.0 * 24).winding_c[1], 25.0, 1e-6);
  EXPECT_NEAR(decayed(ball, hot, 25.0, 1e12).core_c, 25.0, 1e-6);
  EXPECT_EQ(decayed(ball, hot, 25.0, -5.0).winding_c, hot.winding_c);
  EXPECT_EQ(decayed(ball, hot, 25.0, 0.0).core_c, hot.core_c);
}

TEST(Decay, IsTheLimitOfSmallSteps) {
  ThermalModel ball;
  ball.winding_j_k = {30.0, 60.0, 90.0};
  ball.winding_to_core_k_w = {0.5, 1.0, 2.0};
  const ThermalState hot{{50.0, 60.0, 55.0}, 45.0};
  ThermalState stepped = hot;
  HeatLoad load;
  load.ambient_c = 25.0;
  for (int i = 0; i < 600'000; ++i)
    stepped = advanced(stepped, heating_rates(ball, stepped, load), 1e-3);
  const ThermalState exact = decayed(ball, hot, 25.0, 600.0);
  for (std::size_t i = 0; i < kCoils; ++i)
    EXPECT_NEAR(exact.winding_c[i], stepped.winding_c[i], 1e-3);
  EXPECT_NEAR(exact.core_c, stepped.core_c, 1e-3);
}

RC_GTEST_PROP(Decay, IsTheSameInTwoPartsAsInOne, ()) {
  const ThermalModel model = any_model();
  const ThermalState nodes = any_nodes();
  const double first_s = draw(0.001, 10'000);
  const double second_s = draw(0.001, 10'000);
  const ThermalState one = decayed(model, nodes, kAmbientC, first_s + second_s);
  const ThermalState two =
      decayed(model, decayed(model, nodes, kAmbientC, first_s), kAmbientC, second_s);
  for (std::size_t i = 0; i < kCoils; ++i)
    RC_ASSERT(std::abs(one.winding_c[i] - two.winding_c[i]) < 1e-6);
  RC_ASSERT(std::abs(one.core_c - two.core_c) < 1e-6);
}

RC_GTEST_PROP(Decay, NeverWarmsTheHottestWhateverTheConstants, ()) {
  const ThermalModel model = any_model();
  const double dt_s = draw(0.001, 10'000);
  expect_settles(any_nodes(), 20,
                 [&](const ThermalState& nodes) { return decayed(model, nodes, kAmbientC, dt_s); });
}

RC_GTEST_PROP(AcceptedConstants, TheFloorSettles, ()) {
  const ThermalModel model = accepted_model();
  HeatLoad load;
  load.ambient_c = kAmbientC;
  load.fan_running = *rc::gen::arbitrary<bool>();
  expect_settles(any_nodes(), 1000, [&](const ThermalState& nodes) {
    return advanced(nodes, heating_rates(model, nodes, load), 0.1);
  });
}

RC_GTEST_PROP(AcceptedConstants, TheFilterSettles, ()) {
  FilterStart start;
  start.nodes = any_nodes();
  start.ambient_c = kAmbientC;
  ThermalFilter filter(CoilModel{}, accepted_model(), {}, start);
  const bool fan = *rc::gen::arbitrary<bool>();
  expect_settles(start.nodes, 300, [&](const ThermalState&) {
    filter.predict({}, fan, 0.1);
    for (int coil = 0; coil < kCoils; ++coil)
      RC_ASSERT(std::isfinite(filter.winding_deviation_k(coil)));
    return filter.nodes();
  });
}

RC_GTEST_PROP(AcceptedConstants, ThePlantSettlesEvenWhenItIsTenTimesAsLight, ()) {
  Plant plant(PlantParameters::of(CoilModel{}, accepted_model()), kAmbientC);
  PlantErrors errors;
  errors.heat_capacity_gain = 0.1;
  errors.cooling_gain = 10.0;
  plant.set_errors(errors);
  const ThermalState start = any_nodes();
  plant.set_heat(start);
  const double fan = *rc::gen::element(0.0, 1.0);
  expect_settles(start, 500, [&](const ThermalState&) {
    plant.step_thermal({}, fan, 0.1);
    return plant.heat();
  });
}

// Why such constants are rejected: half the filter's step and less.
RC_GTEST_PROP(RefusedConstants, DivergeInTheSteps, ()) {
  ThermalModel model;
  model.winding_j_k.fill(draw(1, 4));
  model.winding_to_core_k_w.fill(0.01);
  RC_ASSERT(!is_accepted(model));
  ThermalState nodes{{60.0, 20.0, 20.0}, 20.0};
  for (int i = 0; i < 100; ++i) nodes = advanced(nodes, heating_rates(model, nodes, {}), 0.1);
  RC_ASSERT(std::abs(nodes.winding_c[0]) > 1000.0);
}

}  // namespace
}  // namespace hedgehog::model
