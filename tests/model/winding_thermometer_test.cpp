// SPDX-License-Identifier: MIT
// A winding compared with the resistance that it had when it was last as warm as its thermometer.
#include "model/estimate/winding_thermometer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "model/tick.h"

namespace hedgehog::model {
namespace {

static_assert(std::is_trivially_copyable_v<WindingThermometer>);

/// A winding of `r25` ohm held at `celsius` at any current, with a thermometer beside it.
struct WindingBench {
  WindingThermometer thermometer{CoilModel{}, ThermalModel{}, 0};
  double r25_ohm = 0.45;
  double celsius = 25.0;
  double voltage_gain = 1.0;
  bool reference = true;

  /// Heats the winding without measuring it, by `warmed_k` in all.
  void warm(double warmed_k) {
    WindingReading reading;
    reading.loss_w = 45.0;
    reading.reference = {celsius, reference};
    const double joule_per_k = ThermalModel{}.winding_j_k[0];
    const auto ticks = std::lround(warmed_k * joule_per_k / (reading.loss_w * kTickSeconds));
    for (int i = 0; i < ticks; ++i) thermometer.step(reading, kTickSeconds);
  }
  void drive(double current_a, double seconds) {
    const double ohm = resistance_at(Ohms(r25_ohm), Celsius(celsius)).value;
    WindingReading reading;
    reading.voltage_v = voltage_gain * ohm * current_a;
    reading.before_a = reading.after_a = current_a;
    reading.measured = current_a != 0.0;
    reading.loss_w = ohm * current_a * current_a;
    reading.reference = {celsius, reference};
    const auto ticks = static_cast<int>(std::lround(seconds / kTickSeconds));
    for (int i = 0; i < ticks; ++i) thermometer.step(reading, kTickSeconds);
  }
};

TEST(WindingThermometer, IsReferencedByItsOwnThermistorWhereThereAreSeveral) {
  ThermistorReadings readings;
  readings.celsius = {21.0, 22.0, 23.0};
  readings.valid = {true, true, false};
  EXPECT_EQ(reference_of(readings, 1, 0, false).celsius, 22.0);
  EXPECT_TRUE(reference_of(readings, 1, 0, false).valid);
  EXPECT_FALSE(reference_of(readings, 2, 0, true).valid);
  readings.valid = {true, false, false};
  EXPECT_EQ(reference_of(readings, 1, 0, true).celsius, 21.0);
  EXPECT_TRUE(reference_of(readings, 1, 0, true).valid);
  EXPECT_FALSE(reference_of(readings, 1, 0, false).valid) << "another winding's, not at rest";
}

TEST(WindingThermometer, TakesItsReferenceWhereItRested) {
  for (const double share : {0.9, 1.0, 1.07}) {
    WindingBench bench;
    bench.r25_ohm *= share;
    bench.celsius = 30.0;
    bench.thermometer.start_rested();
    bench.drive(15.0, 0.3);
    ASSERT_TRUE(bench.thermometer.referenced());
    EXPECT_NEAR(bench.thermometer.r25_ohm(), 0.45 * share, 0.002 * share);
    bench.celsius = 60.0;
    bench.drive(15.0, 0.5);
    EXPECT_NEAR(bench.thermometer.celsius(), 60.0, 0.5) << share;
  }
}

TEST(WindingThermometer, GainsOfVoltageAndCurrentCancel) {
  WindingBench bench;
  bench.voltage_gain = 1.04;
  bench.thermometer.start_rested();
  bench.drive(8.0, 1.0);
  bench.celsius = 65.0;
  bench.drive(8.0, 0.5);
  EXPECT_NEAR(bench.thermometer.celsius(), 65.0, 0.5);
}

TEST(WindingThermometer, IsInvalidBeforeItHasRested) {
  WindingBench bench;
  bench.r25_ohm *= 0.95;
  bench.drive(8.0, 5.0);
  EXPECT_FALSE(bench.thermometer.referenced());
  EXPECT_LT(bench.thermometer.celsius(), 20.0) << "by the device file it looks cold";
  bench.drive(0.0, 300.0);
  EXPECT_FALSE(bench.thermometer.rested());
  bench.drive(0.0, 300.0);
  EXPECT_TRUE(bench.thermometer.rested());
  bench.drive(8.0, 1.0);
  EXPECT_TRUE(bench.thermometer.referenced());
  EXPECT_NEAR(bench.thermometer.celsius(), 25.0, 0.5);
}

TEST(WindingThermometer, TakesNoReferenceWithoutAThermometerOrFromAWarmWinding) {
  WindingBench blind;
  blind.reference = false;
  blind.thermometer.start_rested();
  blind.drive(8.0, 1.0);
  EXPECT_FALSE(blind.thermometer.referenced());

  WindingBench bench;
  bench.thermometer.start_rested();
  bench.drive(15.0, 0.3);
  const double r25 = bench.thermometer.r25_ohm();
  bench.drive(15.0, 20.0);
  bench.r25_ohm = 0.40;  // shorted turns while it is warm
  bench.drive(0.0, 10.0);
  bench.drive(15.0, 1.0);
  EXPECT_EQ(bench.thermometer.r25_ohm(), r25) << "it has not cooled yet";
}

/// A reference for which 10 A were measured for `seconds` until the winding was 3 K warmer than at
/// its rest.
bool referenced_after(double seconds) {
  WindingBench bench;
  bench.thermometer.start_rested();
  bench.warm(3.0 - 45.0 * seconds / ThermalModel{}.winding_j_k[0]);
  bench.drive(10.0, seconds + 0.1);
  return bench.thermometer.referenced();
}

TEST(WindingThermometer, AWarmedWindingNeedsTwentyAmpereSquaredSeconds) {
  EXPECT_FALSE(referenced_after(0.15));
  EXPECT_TRUE(referenced_after(0.25));
}

TEST(WindingThermometer, RestsTwiceAsLongWithTwiceTheThermalResistance) {
  const auto rest_s = [](double winding_to_core_k_w) {
    ThermalModel thermal;
    thermal.winding_to_core_k_w[2] = winding_to_core_k_w;
    WindingBench bench;
    bench.thermometer = WindingThermometer(CoilModel{}, thermal, 2);
    double seconds = 0.0;
    for (; !bench.thermometer.rested() && seconds < 3600.0; seconds += 0.1) bench.drive(0.0, 0.1);
    return seconds;
  };
  EXPECT_NEAR(rest_s(2.0) / rest_s(1.0), 2.0, 0.01);
}

TEST(WindingThermometer, AnOffsetCountsByHowFarTheCurrentIsFromItsReferences) {
  WindingBench bench;
  bench.thermometer.set_accuracy({0.05, 0.03, true});
  bench.thermometer.start_rested();
  bench.drive(5.0, 2.0);
  ASSERT_TRUE(bench.thermometer.referenced());
  EXPECT_NEAR(bench.thermometer.bias_k(), 0.0, 0.05);
  bench.drive(15.0, 1.0);
  // 0.03 A are 0.6 % of 5 A and 0.2 % of 15 A.
  EXPECT_NEAR(bench.thermometer.bias_k(), 0.004 * 254.0, 0.1);
}

}  // namespace
}  // namespace hedgehog::model
