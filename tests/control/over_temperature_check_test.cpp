// SPDX-License-Identifier: MIT
// Windings and thermistors at the trip temperature, and windings that are too cold to be true.
#include "daemon/control/checks/over_temperature_check.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "model/tick.h"

namespace hedgehog::control {
namespace {

/// A tick of a steady current in winding `coil`, which is at `celsius`.
HeatReading steady(int coil, double current_a, double celsius, double r25_ohm = 0.45) {
  HeatReading reading;
  reading.electrical = true;
  reading.thermistors.valid[0] = true;
  reading.thermistors.celsius[0] = 30.0;
  reading.before_a[coil] = reading.after_a[coil] = current_a;
  reading.voltage_v[coil] = current_a * r25_ohm * (1.0 + 0.00393 * (celsius - 25.0));
  return reading;
}

/// A check with a reference resistance of winding `coil`: it was driven while the ball was at 30 C.
OverTemperatureCheck referenced(int coil) {
  OverTemperatureCheck check;
  check.start_rested();
  for (int i = 0; i < 300; ++i)
    check.step(steady(coil, i < 10 ? 0.0 : 15.0, 30.0), 70.0, model::kTickSeconds);
  EXPECT_TRUE(check.referenced(coil));
  return check;
}

TEST(OverTemperatureCheck, AWindingAtSeventyForFiftyMilliseconds) {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    OverTemperatureCheck check = referenced(coil);
    const auto drive = [&](double celsius) {
      return check.step(steady(coil, -5.0, celsius), 70.0, model::kTickSeconds);
    };
    for (int i = 0; i < 5000; ++i) ASSERT_EQ(drive(69.5), Reason::kNone);
    EXPECT_NEAR(check.winding_c(coil), 69.5, 0.3);
    int ticks = 0;
    while (drive(71.0) == Reason::kNone && ticks < 1000) ++ticks;
    EXPECT_LT(ticks, 130);
    EXPECT_GE(ticks, 49);
  }
}

TEST(OverTemperatureCheck, AWindingIsCheckedByItsPresentCurrentOnly) {
  OverTemperatureCheck check = referenced(1);
  const auto tick = [&](double current_a) {
    return check.step(steady(1, current_a, 72.0), 70.0, model::kTickSeconds);
  };
  for (int i = 0; i < 20; ++i) ASSERT_EQ(tick(6.0), Reason::kNone);
  ASSERT_TRUE(check.measuring(1));
  for (int i = 0; i < 200; ++i) ASSERT_EQ(tick(0.0), Reason::kNone) << i;
  // A pulse train, 8 ms of every 80: only driven milliseconds count for the 50 ms.
  int driven = 0;
  for (int i = 0; i < 3000; ++i) {
    const bool on = i % 80 < 8;
    driven += on ? 1 : 0;
    if (tick(on ? 12.0 : 0.0) != Reason::kNone) break;
  }
  EXPECT_GE(driven, 49);
  EXPECT_LE(driven, 120);
}

TEST(OverTemperatureCheck, EachWindingIsMeasuredByItsOwnResistance) {
  model::CoilModel coils;
  coils.r25_ohm = {0.40, 0.45, 0.50};
  for (int coil = 0; coil < model::kCoils; ++coil) {
    OverTemperatureCheck check(coils, model::ThermalModel{});
    const double r25_ohm = coils.r25_ohm[static_cast<std::size_t>(coil)];
    for (int i = 0; i < 1000; ++i)
      check.step(steady(coil, 8.0, 50.0, r25_ohm), 70.0, model::kTickSeconds);
    ASSERT_TRUE(check.measuring(coil));
    EXPECT_NEAR(check.winding_c(coil), 50.0, 0.5) << coil;
  }
}

TEST(OverTemperatureCheck, TheMinMeasuredCurrentIsEvidence) {
  OverTemperatureCheck check = referenced(1);
  int ticks = 0;
  while (check.step(steady(1, model::WindingMeter::kMinCurrentA, 100.0), 70.0,
                    model::kTickSeconds) == Reason::kNone &&
         ticks < 1000)
    ++ticks;
  EXPECT_LT(ticks, 400);
}

TEST(OverTemperatureCheck, HowColdAWindingMayBeDependsOnItsThermistor) {
  struct Case {
    std::optional<double> thermistor_c;
    double winding_c;
    Reason expected;
  };
  for (const Case& one :
       {Case{0.0, -12.0, Reason::kNone}, Case{0.0, -25.0, Reason::kCurrentMismatch},
        Case{30.0, 6.0, Reason::kNone}, Case{30.0, -5.0, Reason::kCurrentMismatch},
        Case{{}, 6.0, Reason::kNone}, Case{{}, -5.0, Reason::kCurrentMismatch}}) {
    OverTemperatureCheck check = referenced(0);
    HeatReading reading = steady(0, 8.0, one.winding_c);
    reading.thermistors.valid[0] = one.thermistor_c.has_value();
    reading.thermistors.celsius[0] = one.thermistor_c.value_or(0.0);
    Reason reason = Reason::kNone;
    for (int i = 0; i < 2000 && reason == Reason::kNone; ++i)
      reason = check.step(reading, 70.0, model::kTickSeconds);
    EXPECT_EQ(reason, one.expected) << one.winding_c << " C";
  }
}

TEST(OverTemperatureCheck, AWindingColderThanAnyAmbientForHalfASecondIsAMismatch) {
  OverTemperatureCheck check;
  int ticks = 0;
  while (check.step(steady(2, 8.0, -60.0), 70.0, model::kTickSeconds) == Reason::kNone &&
         ticks < 2000)
    ++ticks;
  EXPECT_GE(ticks, 499);
  EXPECT_LT(ticks, 700);
  EXPECT_EQ(check.step(steady(2, 8.0, -60.0), 70.0, model::kTickSeconds), Reason::kCurrentMismatch);
}

TEST(OverTemperatureCheck, TheThermistorAtSeventyForFiftyMilliseconds) {
  OverTemperatureCheck check;
  HeatReading reading;
  reading.thermistors.valid[0] = true;
  for (int round = 0; round < 100; ++round) {
    reading.thermistors.celsius[0] = 70.5;
    for (int i = 0; i < 40; ++i)
      ASSERT_EQ(check.step(reading, 70.0, model::kTickSeconds), Reason::kNone);
    reading.thermistors.celsius[0] = 69.5;
    for (int i = 0; i < 40; ++i)
      ASSERT_EQ(check.step(reading, 70.0, model::kTickSeconds), Reason::kNone);
  }
  reading.thermistors.celsius[0] = 70.0;
  int ticks = 1;
  while (check.step(reading, 70.0, model::kTickSeconds) == Reason::kNone && ticks < 100) ++ticks;
  EXPECT_EQ(ticks, 50);
}

}  // namespace
}  // namespace hedgehog::control
