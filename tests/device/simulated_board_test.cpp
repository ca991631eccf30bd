// SPDX-License-Identifier: MIT
// Link and simulated board together, in virtual time: the resulting currents.
#include <gtest/gtest.h>

#include <cmath>

#include "daemon/device/simulator/lock_step.h"
#include "tests/device/exact_board.h"
#include "tests/device/limited.h"

namespace hedgehog::device {
namespace {

struct Together : testing::Test {
  LinkPort port;
  LockStep both{port, exact()};
  LinkCommand command;
  SimulatorSettings settings;
  model::Vec3 requested{5, 0, 0};
  bool feeding = true;

  const BoardTelemetry& telemetry() { return both.link().report().telemetry; }
  const model::Plant& plant() { return both.board().plant(); }
  double current() { return norm(plant().current_a()); }
  bool has(BoardFault fault) { return (both.board().core().faults() & fault) != 0; }

  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      if (feeding) {
        const std::uint8_t arm_count = command.board.arm_count;
        const model::Vec3 settled = requested;
        command.board = BoardCommand::drive(limited(requested), kColdOhm, 1.5e-3, settled, 12.0);
        command.board.arm_count = arm_count;
        ++command.count;
      }
      port.commands.write(command);
      both.step();
    }
  }
  void arm() {
    run(2);
    ++command.board.arm_count;
    run(3);
  }
  void fault(unsigned bits, std::uint8_t coil = 0) {
    settings.faults = static_cast<std::uint16_t>(bits);
    settings.coil = coil;
    port.simulator.write(settings);
  }
  // The windings are without current within 5 L/R.
  void expect_zero_soon() {
    run(17);
    EXPECT_LT(current(), 0.1);
  }
};

TEST_F(Together, DoesNothingUntilArmed) {
  run(1000);
  EXPECT_EQ(current(), 0.0);
  EXPECT_EQ(telemetry().mode, BoardMode::kSafe);
  EXPECT_TRUE(both.link().report().present);
  arm();
  run(50);
  EXPECT_EQ(telemetry().mode, BoardMode::kDriving);
  EXPECT_NEAR(current(), 5.0, 0.05);
}

TEST_F(Together, AStepToFifteenAmperesFollowsTheInductance) {
  requested = {0, 0, 0};
  arm();
  requested = {0, 15, 0};
  // No feed-forward here (`settled`), so I = 15 (1 - exp(-t R/L)), L/R = 3.33 ms.
  for (int ms = 1; ms <= 20; ++ms) {
    run(1);
    EXPECT_NEAR(plant().current_a().y, 15.0 * (1.0 - std::exp(-ms * 0.45 / 1.5)), 0.02) << ms;
  }
}

TEST_F(Together, TheFirstBoardsSequenceCountsFromOneAndNothingIsLost) {
  run(500);
  EXPECT_EQ(both.link().report().counters.lost, 0u);
  EXPECT_EQ(both.link().report().counters.errors, 0u);
  EXPECT_EQ(telemetry().sequence, 500u);
}

TEST_F(Together, ControlThatFallsSilentIsReplacedBySafeAfterTwentyTicks) {
  arm();
  run(50);
  feeding = false;
  run(19);
  EXPECT_GT(current(), 4.9);
  run(1);
  EXPECT_FALSE(both.board().core().outputs().awake);
  expect_zero_soon();
  EXPECT_EQ(telemetry().faults, 0) << "the link feeds the dead-man with safe set-points";
}

TEST_F(Together, APulledCableIsSafeAfterAHundredMillisecondsOfTheBoard) {
  arm();
  run(50);
  fault(kSimSilent);
  run(1);  // the frame that carries the fault still follows a set-point
  run(99);
  EXPECT_TRUE(both.board().core().outputs().awake);
  run(1);
  EXPECT_FALSE(both.board().core().outputs().awake);
  EXPECT_TRUE(has(board::kDeadMan));
  expect_zero_soon();
  EXPECT_FALSE(both.link().report().present);
  fault(0);
  run(1000);
  EXPECT_TRUE(has(board::kDeadMan)) << "latched although set-points are back";
  EXPECT_EQ(current(), 0.0);
  ++command.board.arm_count;
  run(50);
  EXPECT_NEAR(current(), 5.0, 0.05);
}

TEST_F(Together, ACurrentThatReadsThirtyPercentLowIsMadeSafeByTheSupplyCurrent) {
  arm();
  requested = {0, 10, 0};
  run(100);
  SimulatorErrorList errors;
  errors.error[errors.count++] = {SimulatorErrorKind::kCurrentGain, 1, 0.7, 0.0};
  both.board().set_errors(errors);
  int ms = 0;
  for (; ms < 4000 && both.board().core().outputs().awake; ++ms) run(1);
  EXPECT_GT(ms, 1000) << "the mean, not the rule of 20 ms";
  EXPECT_LT(ms, 3000);
  EXPECT_TRUE(has(board::kUnexpectedCurrent));
  expect_zero_soon();
}

TEST_F(Together, AStuckBridgeIsDetectedAndOpensTheSupplySwitchInTime) {
  arm();
  requested = {0, 0, 0};
  run(100);
  fault(kSimStuckBridge, 2);
  int ms = 0;
  for (; ms < 30 && both.board().core().outputs().awake; ++ms) run(1);
  EXPECT_LE(ms, 10) << "10 % of 12 V, where nothing was asked";
  EXPECT_TRUE(has(board::kUnexpectedCurrent));
  EXPECT_GT(current(), 1.0) << "it does not obey SLP";
  run(19);
  EXPECT_TRUE(both.board().core().outputs().supply_switch_closed);
  EXPECT_NEAR(plant().current_a().z, 1.2 / 0.45, 0.01);
  run(1);
  EXPECT_FALSE(both.board().core().outputs().supply_switch_closed);
  EXPECT_TRUE(has(board::kStuckBridge));
  expect_zero_soon();
}

TEST_F(Together, ABridgeFaultIsLatched) {
  arm();
  run(50);
  fault(kSimBridgeFault, 0);
  run(5);
  EXPECT_TRUE(has(board::kBridge));
  expect_zero_soon();
}

TEST_F(Together, ABrokenThermistorLineIsLatched) {
  for (const auto& [sim, expected] : {std::pair{kSimSensorOpen, board::kSensorOpen},
                                      std::pair{kSimSensorShort, board::kSensorShort}}) {
    fault(0);
    arm();
    run(50);
    ASSERT_GT(current(), 4.9);
    fault(sim);
    run(21);
    EXPECT_TRUE(has(expected));
    expect_zero_soon();
  }
}

TEST_F(Together, AFallingSupplyIsLatched) {
  arm();
  run(50);
  fault(kSimSupplyLow);
  run(12);
  EXPECT_TRUE(has(board::kSupply));
  expect_zero_soon();
  EXPECT_NEAR(telemetry().supply_v, 5.0, 1e-9);
}

TEST_F(Together, AFrozenSensorGoesOnConvertingAndAStaleOneDoesNot) {
  run(100);
  fault(kSimSensorFrozen);
  run(20);
  const double frozen_c = telemetry().sensor_c;
  std::uint8_t conversions = telemetry().sensor_conversions;
  both.board().plant().set_heat({{50, 50, 50}, 50});
  run(1000);
  EXPECT_EQ(telemetry().sensor_c, frozen_c);
  EXPECT_EQ(static_cast<std::uint8_t>(telemetry().sensor_conversions - conversions), 100);
  fault(kSimSensorStale);
  run(20);
  conversions = telemetry().sensor_conversions;
  run(1000);
  EXPECT_EQ(telemetry().sensor_conversions, conversions);
  fault(0);
  run(100);
  EXPECT_NEAR(telemetry().sensor_c, 49.6, 1.0);
}

TEST_F(Together, ASensorJumpsOrDrifts) {
  run(100);
  fault(kSimSensorJump);
  run(20);
  EXPECT_NEAR(telemetry().sensor_c, 40.0, 1.0);
  fault(kSimSensorOffset);
  run(10'000);
  EXPECT_NEAR(telemetry().sensor_c, 20.0, 1.0) << "-0.5 K/s";
  fault(0);
  run(20);
  EXPECT_NEAR(telemetry().sensor_c, 25.0, 1.0);
}

TEST_F(Together, WindingAndCurrentSenseFaultsShowInTheCurrents) {
  arm();
  run(50);
  fault(kSimCurrentSense, 0);
  run(2);
  EXPECT_NEAR(telemetry().current_a.x, 2.5, 0.05);
  EXPECT_NEAR(plant().current_a().x, 5.0, 0.05);
  fault(kSimOpenWinding, 0);
  run(2);
  EXPECT_EQ(plant().current_a().x, 0.0);
  EXPECT_NEAR(telemetry().duty.x, 5 * 0.45 / 12, 1e-3);
}

TEST_F(Together, ASeizedFanRunsOut) {
  arm();
  command.board.fan = 255;
  feeding = false;
  for (int i = 0; i < 5000; ++i) {
    ++command.count;
    run(1);
  }
  EXPECT_NEAR(telemetry().fan_rpm, 7200, 100);
  fault(kSimFanStopped);
  for (int i = 0; i < 5000; ++i) {
    ++command.count;
    run(1);
  }
  EXPECT_LT(telemetry().fan_rpm, 100);
  EXPECT_EQ(telemetry().fan_duty, 1.0);
}

TEST_F(Together, FifteenAmperesWithoutALimiterHitTheBoardsOwnLimits) {
  requested = {15, 0, 0};
  arm();
  int ms = 0;
  for (; ms < 120'000 && both.board().core().outputs().awake; ++ms) run(1);
  EXPECT_TRUE(has(board::kOverHeat));
  EXPECT_LT(plant().hottest_winding_c(), 82.0) << "75 C at the sensor, which lags by 2 s";
  expect_zero_soon();
}

TEST_F(Together, EvenWithAFrozenSensorTheBoardStopsAtItsHeatBudget) {
  run(100);
  fault(kSimSensorFrozen);
  requested = {15, 0, 0};
  arm();
  int ms = 0;
  for (; ms < 120'000 && both.board().core().outputs().awake; ++ms) run(1);
  EXPECT_TRUE(has(board::kHeatBudget));
  EXPECT_LT(plant().hottest_winding_c(), 100.0);
  expect_zero_soon();
}

TEST(SimulatedBoardStart, HasTheConfiguredTemperaturesAndIsReproducible) {
  SimulatedBoardOptions options;
  options.start_c = 53.0;
  options.ambient_c = 20.0;
  SimulatedBoard one(options);
  SimulatedBoard other(options);
  EXPECT_EQ(one.plant().hottest_winding_c(), 53.0);
  EXPECT_EQ(one.plant().ambient_c(), 20.0);
  for (int ms = 0; ms < 1000; ++ms) ASSERT_EQ(one.step(), other.step());
  EXPECT_NEAR(decode_telemetry(*one.step()).telemetry.sensor_c, 53.0, 1.0);
}

}  // namespace
}  // namespace hedgehog::device
