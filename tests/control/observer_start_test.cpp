// SPDX-License-Identifier: MIT
// The temperatures from which the controller's estimate starts: saved ones, or the thermistor's.
#include <gtest/gtest.h>

#include <array>

#include "tests/control/controlled.h"
#include "tests/rig/rig.h"

namespace hedgehog::control {
namespace {

/// The estimate after the first reading, `sensor_c`, and that of an observer started at `expected`.
void expect_start(const ControlSettings& settings, double sensor_c,
                  const model::ThermalStart& expected) {
  Controlled ball(settings);
  ball.inputs.board.sensor_c = sensor_c;
  ball.step();
  model::ThermalObserver observer(settings.coils, settings.thermal, expected, settings.uncertainty);
  const model::ThermalEstimate found = ball.controller.thermal();
  const model::ThermalEstimate& wanted = observer.estimate();
  EXPECT_EQ(found.nodes.winding_c, wanted.nodes.winding_c);
  EXPECT_EQ(found.nodes.core_c, wanted.nodes.core_c);
  EXPECT_EQ(found.deviation_k, wanted.deviation_k);
  EXPECT_EQ(found.ambient_c, wanted.ambient_c);
  EXPECT_EQ(found.measured, wanted.measured);
}

ControlSettings saved(const model::ThermalState& nodes) {
  ControlSettings settings;
  settings.start_known = true;
  settings.start = nodes;
  settings.start_deviation_k = 0.4;
  settings.start_ambient_c = 21.0;
  settings.start_measured = {true, false, true};
  return settings;
}

model::ThermalStart known(const model::ThermalState& nodes, double deviation_k) {
  model::ThermalStart start;
  start.nodes = nodes;
  start.known = true;
  start.deviation_k = deviation_k;
  start.ambient_c = 21.0;
  start.measured = {true, false, true};
  return start;
}

TEST(ObserverStart, WithoutASavedStateEachNodeIsAtTheThermistor) {
  model::ThermalStart start;
  start.nodes = {{41.0, 41.0, 41.0}, 41.0};
  ControlSettings settings = saved({{60.0, 60.0, 60.0}, 60.0});
  settings.start_known = false;
  expect_start(settings, 41.0, start);
}

TEST(ObserverStart, ASavedStateThatTheThermistorConfirmsIsTaken) {
  const model::ThermalState nodes{{50.0, 40.0, 35.0}, 33.0};
  expect_start(saved(nodes), 33.0, known(nodes, 0.4));
}

TEST(ObserverStart, AColderThermistorLowersNothing) {
  const model::ThermalState nodes{{50.0, 40.0, 35.0}, 33.0};
  expect_start(saved(nodes), 25.0, known(nodes, 0.4));
}

TEST(ObserverStart, AWarmerThermistorRaisesTheColderNodesAndTheirDeviation) {
  expect_start(saved({{50.0, 40.0, 50.0}, 30.0}), 34.0,
               known({{50.0, 40.0, 50.0}, 34.0}, 0.4 + 0.5 * 3.0));
  expect_start(saved({{50.0, 29.0, 30.0}, 40.0}), 34.0,
               known({{50.0, 34.0, 34.0}, 40.0}, 0.4 + 0.5 * 4.0));
  expect_start(saved({{30.0, 30.0, 30.0}, 30.0}), 30.9, known({{30.9, 30.9, 30.9}, 30.9}, 0.4));
}

TEST(ObserverStart, AnotherBallStartsAtTheThermistor) {
  Controlled ball(saved({{50.0, 40.0, 35.0}, 33.0}));
  ball.run(10);
  ball.command(ResetBall{});
  EXPECT_EQ(name(ball.controller.reason()), "state_lost");
  ball.step();
  const model::ThermalEstimate found = ball.controller.thermal();
  EXPECT_EQ(found.nodes.winding_c, (std::array<double, 3>{25.0, 25.0, 25.0}));
  EXPECT_EQ(found.measured, (std::array<bool, 3>{}));
  EXPECT_GT(found.deviation_k[0], 10.0) << "a guess";
}

TEST(ObserverStart, TheResistancesOfTheBallBeforeAreDiscarded) {
  rig::Rig rig;
  rig.run_until_armed();
  const auto play = [&](int seconds) {
    const auto effect = rig.start(rig::hold({1, 1, 1}, 12.0));
    for (int s = 0; s < seconds; ++s) {
      rig.update(effect, rig::hold({1, 1, 1}, 12.0));
      rig.run(1000);
    }
    rig.stop(effect);
  };
  play(10);
  device::SimulatedBoardOptions other;
  for (double& ohm : other.plant.r25_ohm) ohm *= 1.07;
  rig.board() = device::SimulatedBoard(other);
  rig.command(ResetBall{});
  rig.run_s(60.0);
  rig.arm();
  rig.run(20);
  ASSERT_EQ(name(rig.controller().state()), "armed");
  play(20);
  EXPECT_EQ(name(rig.controller().state()), "armed") << name(rig.controller().reason());
}

}  // namespace
}  // namespace hedgehog::control
