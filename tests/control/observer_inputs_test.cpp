// SPDX-License-Identifier: MIT
// Measurements from which the controller's estimate is made, and what the controller makes of it.
#include <gtest/gtest.h>

#include <limits>

#include "tests/control/controlled.h"
#include "tests/rig/rig.h"

namespace hedgehog::control {
namespace {

ControlSettings rested() {
  ControlSettings settings;
  settings.start_known = true;
  settings.start_measured.fill(true);
  return settings;
}

constexpr int kPlayed = 1;
constexpr double kObservedOhm = 0.45;

/// Bridges that apply `current_a` to the resistance at 25 C of a winding, at supply voltage
/// `supply_v`.
void drive(device::BoardTelemetry& board, double current_a, double supply_v) {
  board.bridges_awake = true;
  board.supply_v = supply_v;
  board.current_a[kPlayed] = current_a;
  board.duty[kPlayed] = current_a * kObservedOhm / supply_v;
}

/// A controller whose ball sleeps for 2 s with current readings of `reading_a`, then plays for 3 s,
/// beside an observer with the same measurements.
void expect_offset_learnt(const model::CurrentAccuracy& accuracy, double reading_a, bool learns) {
  Controlled ball(rested());
  device::BoardTelemetry& board = ball.inputs.board;
  board.accuracy = accuracy;
  model::ThermalStart start;
  start.known = true;
  const ControlSettings settings = rested();
  start.deviation_k = settings.start_deviation_k;
  start.ambient_c = settings.start_ambient_c;
  start.measured = settings.start_measured;
  model::ThermalObserver observer(settings.coils, settings.thermal, start, settings.uncertainty);
  model::ThermalMeasurement expected;
  expected.supply_v = 12.0;
  expected.accuracy = accuracy;
  expected.thermistors.valid[static_cast<std::size_t>(settings.thermal.sensor_winding)] = true;
  const auto step = [&] {
    ball.step();
    expected.current_a = board.current_a;
    expected.voltage_v = 12.0 * board.duty;
    observer.step(expected);
    expected.current_before_a = board.current_a;
    expected.electrical_valid = board.bridges_awake;
  };
  board.current_a[kPlayed] = reading_a;
  for (int tick = 1; tick <= 2000; ++tick) {
    expected.idle = learns && tick > 100;
    expected.idle_a = board.current_a;
    step();
  }
  expected.idle = false;
  drive(board, 5.0, 12.0);
  for (int tick = 0; tick < 3000; ++tick) step();
  const model::ThermalEstimate found = ball.controller.thermal();
  EXPECT_EQ(found.nodes.winding_c, observer.estimate().nodes.winding_c);
  EXPECT_EQ(found.deviation_k, observer.estimate().deviation_k);
}

TEST(ObserverInputs, ReadingsOfSleepingBridgesAreTheOffset) {
  expect_offset_learnt(model::kInLineAccuracy, 0.02, true);
}

TEST(ObserverInputs, SleepingSensorsWithoutSignShowNoOffset) {
  expect_offset_learnt(model::kDriverCsAccuracy, 0.1, false);
}

TEST(ObserverInputs, AThermistorThatIsNotConvertedMeasuresNothing) {
  Controlled ball(rested());
  ball.run(100);
  ball.converting = false;
  ball.run(240);
  EXPECT_LT(ball.controller.thermal().hottest_c, 40.0);
  ball.run(150);
  EXPECT_EQ(ball.controller.thermal().hottest_c, std::numeric_limits<double>::infinity());
}

/// Bound of a winding without thermistor whose supply reads `later_v` after its reference at 12 V,
/// while its current and V/I remain as they were.
double bound_after_supply_reads(double later_v) {
  ControlSettings settings = rested();
  settings.thermal.sensor_winding = 0;
  Controlled ball(settings);
  ball.inputs.board.accuracy = model::kInLineAccuracy;
  ball.run(200);
  drive(ball.inputs.board, 6.0, 12.0);
  ball.run(2000);
  drive(ball.inputs.board, 6.0, later_v);
  ball.run(2000);
  return ball.controller.thermal().upper_c[kPlayed];
}

TEST(ObserverInputs, ASupplyReadingThatFellMakesVOverIUncertain) {
  EXPECT_GT(bound_after_supply_reads(11.0), bound_after_supply_reads(12.0) + 10.0);
}

TEST(Trips, ByContradictionsOnlyWhileArmed) {
  rig::RigOptions options;
  options.control.arm_at_start = false;
  options.board.front_end.thermistors = 3;
  rig::Rig rig(options);
  device::SimulatorErrorList errors;
  errors.generation = 1;
  errors.count = 1;
  errors.error[0] = {device::SimulatorErrorKind::kThermistorOffsetK, 2, 20.0, 20.0};
  rig.board().set_errors(errors);
  rig.run_s(60.0);
  EXPECT_EQ(name(rig.controller().state()), "disarmed") << name(rig.controller().reason());
  rig.arm();
  rig.run_s(2.0);
  EXPECT_EQ(name(rig.controller().reason()), "measurements_disagree");
}

TEST(Skin, WithoutAProbeItsBoundIsTheEstimateAndItsMargin) {
  Controlled ball(rested());
  ball.run(200);
  const SkinStatus skin = ball.snapshot().skin;
  EXPECT_GE(skin.above_k, model::SkinEstimate::kMinMarginK);
  EXPECT_EQ(skin.above_k, skin.estimate.margin_k());
  EXPECT_DOUBLE_EQ(skin.bound_c, skin.estimate.celsius());
}

}  // namespace
}  // namespace hedgehog::control
