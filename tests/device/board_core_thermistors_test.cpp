// SPDX-License-Identifier: MIT
// Several thermistors: each one that is wired counts, and all are reported.
#include <gtest/gtest.h>

#include <limits>

#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

CoreBench with_thermistors(std::uint8_t count) {
  CoreBench bench;
  bench.inputs.thermistors = count;
  // Thermistors that are not wired read as open, with values out of range.
  for (int k = count; k < kWindings; ++k) bench.inputs.thermistor[k] = {9000, true, false};
  return bench;
}

TEST(BoardCoreThermistors, OnlyWiredOnesAreChecked) {
  for (int count = 1; count <= kWindings; ++count) {
    CoreBench bench = with_thermistors(static_cast<std::uint8_t>(count));
    bench.arm_and_drive();
    bench.run(200);
    ASSERT_TRUE(bench.drives()) << count;
    for (int k = 0; k < count; ++k) {
      CoreBench hot = bench;
      hot.inputs.thermistor[k].cc = 7501;
      hot.run(50);
      EXPECT_TRUE(hot.latched_by(kOverHeat)) << k << " of " << count;
      CoreBench open = bench;
      open.inputs.thermistor[k].open = true;
      open.run(20);
      EXPECT_TRUE(open.latched_by(kSensorOpen)) << k << " of " << count;
      CoreBench shorted = bench;
      shorted.inputs.thermistor[k].shorted = true;
      shorted.inputs.thermistor[k].cc = std::numeric_limits<std::int16_t>::max();
      shorted.run(100);
      EXPECT_TRUE(shorted.latched_by(kSensorShort)) << k << " of " << count;
      EXPECT_FALSE(shorted.has(kOverHeat)) << "its reading is no temperature";
    }
  }
}

TEST(BoardCoreThermistors, WithoutAHostTheFanRunsFromFortyDegreesOfAnyWiredOne) {
  for (int count = 1; count <= kWindings; ++count) {
    CoreBench bench = with_thermistors(static_cast<std::uint8_t>(count));
    bench.feeding = false;
    for (int k = 0; k < count; ++k) bench.inputs.thermistor[k].cc = 3999;
    bench.run(1);
    ASSERT_EQ(bench.outputs.fan, 0) << count;
    for (int k = 0; k < count; ++k) {
      for (const ThermistorInput& warm :
           {ThermistorInput{4000, false, false}, ThermistorInput{2000, true, false},
            ThermistorInput{2000, false, true}}) {
        bench.inputs.thermistor[k] = warm;
        bench.run(1);
        EXPECT_EQ(bench.outputs.fan, 255) << k << " of " << count;
      }
      bench.inputs.thermistor[k] = {3999, false, false};
    }
  }
}

TEST(BoardCoreThermistors, ThoseAfterTheFirstAreReportedInTurnTwoFramesEach) {
  CoreBench bench = with_thermistors(3);
  for (int k = 0; k < kWindings; ++k)
    bench.inputs.thermistor[k].cc = static_cast<std::int16_t>(2000 + k);
  for (int ms = 1; ms <= 40; ++ms) {
    bench.run(1);
    const TelemetryFrame telemetry = bench.telemetry();
    EXPECT_EQ(telemetry.thermistors, 3);
    EXPECT_EQ(telemetry.sensor_cc, 2000);
    EXPECT_EQ(telemetry.other_thermistor, 1 + ms / 2 % 2);
    EXPECT_EQ(telemetry.other_cc, 2000 + telemetry.other_thermistor);
  }
}

TEST(BoardCoreThermistors, TheSecondOfTwoIsReportedInEachFrame) {
  CoreBench bench = with_thermistors(2);
  bench.inputs.thermistor[1].cc = 3100;
  for (int ms = 0; ms < 10; ++ms) {
    bench.run(1);
    EXPECT_EQ(bench.telemetry().other_thermistor, 1);
    EXPECT_EQ(bench.telemetry().other_cc, 3100);
  }
  bench.inputs.thermistor[1].open = true;
  bench.run(1);
  EXPECT_EQ(bench.telemetry().other_cc, kOpenCc);
  bench.inputs.thermistor[1] = {3100, false, true};
  bench.run(1);
  EXPECT_EQ(bench.telemetry().other_cc, kShortCc);
}

TEST(BoardCoreThermistors, WithOneNoOtherIsReported) {
  CoreBench bench = with_thermistors(1);
  bench.run(3);
  EXPECT_EQ(bench.telemetry().thermistors, 1);
  EXPECT_EQ(bench.telemetry().other_thermistor, TelemetryFrame{}.other_thermistor);
}

TEST(BoardCoreThermistors, ConversionsAreCounted) {
  CoreBench bench;
  bench.run(3);
  bench.inputs.thermistors_converted = false;
  bench.run(4);
  EXPECT_EQ(bench.telemetry().sensor_conversions, 3);
}

// -- other telemetry ------------------------------------------------------------------------------

TEST(BoardCoreTelemetry, HasTheMeasuredValues) {
  CoreBench bench;
  bench.inputs.supply_mv = 11'987;
  bench.inputs.currents_measured = 5;
  bench.inputs.currents_in_line = true;
  bench.inputs.supply_current_measured = true;
  bench.inputs.supply_ma = 321;
  bench.inputs.fan_rpm = 4321;
  bench.set_point.fan = 77;
  bench.arm_and_drive();
  const TelemetryFrame telemetry = bench.telemetry();
  EXPECT_EQ(telemetry.supply_mv, 11'987);
  EXPECT_EQ(telemetry.currents_measured, 5);
  EXPECT_TRUE(telemetry.currents_in_line);
  EXPECT_TRUE(telemetry.supply_current_measured);
  EXPECT_EQ(telemetry.supply_ma, 321);
  EXPECT_EQ(telemetry.fan_rpm, 4321);
  EXPECT_EQ(telemetry.fan, 77);
  EXPECT_EQ(telemetry.mode, static_cast<std::uint8_t>(Mode::kDriving));
  EXPECT_TRUE(telemetry.supply_switch_closed);
  EXPECT_EQ(telemetry.faults, 0);
  EXPECT_EQ(telemetry.received_sequence, bench.sequence);
  EXPECT_EQ(telemetry.sensor_limit_cc, 7500);
  EXPECT_EQ(telemetry.current_limit_ma, 16'500);
}

TEST(BoardCoreTelemetry, TheAgeOfTheSetPointStopsAt255) {
  CoreBench bench;
  bench.feed();
  bench.feeding = false;
  for (const int age_ms : {0, 254, 255, 255}) {
    while (bench.core.set_point_age_ms() != static_cast<std::uint32_t>(age_ms)) bench.run(1);
    EXPECT_EQ(bench.telemetry().set_point_age_ms, age_ms);
  }
  bench.run(1);
  EXPECT_EQ(bench.telemetry().set_point_age_ms, 255);
}

}  // namespace
}  // namespace hedgehog::board
