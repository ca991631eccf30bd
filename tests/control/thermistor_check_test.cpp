// SPDX-License-Identifier: MIT
// The watchdog's check of a thermistor's own readings: trip conditions, their delays, and tolerated
// readings.
#include <gtest/gtest.h>

#include <limits>

#include "tests/control/thermistor_sensor.h"

namespace hedgehog::control {
namespace {

TEST(ThermistorCheck, IsNotPlausibleBeforeItsFirstReading) {
  Sensor sensor;
  EXPECT_EQ(sensor.check.arming_blocker(), Reason::kSensorStale);
  EXPECT_FALSE(sensor.check.usable());
  sensor.step(25.0);
  EXPECT_EQ(sensor.check.arming_blocker(), Reason::kNone);
  EXPECT_TRUE(sensor.check.usable());
}

TEST(ThermistorCheck, ImplausibleOutsideMinusTwentyToHundredAndTwentyFive) {
  for (const double c : {-20.1, 125.0, std::numeric_limits<double>::quiet_NaN()}) {
    Sensor sensor;
    EXPECT_EQ(sensor.step(c), Reason::kNone);
    EXPECT_FALSE(sensor.check.usable()) << "not used from the first implausible reading on";
    const auto [reason, ticks] = sensor.until_trip(c, 100);
    EXPECT_EQ(name(reason), "sensor_implausible");
    EXPECT_EQ(ticks, 39);
  }
  for (const double c : {-20.0, 124.9}) {
    Sensor sensor;
    EXPECT_EQ(sensor.until_trip(c, 500).first, Reason::kNone);
  }
}

TEST(ThermistorCheck, AJumpTripsAfterTwentyMillisecondsOneOddReadingDoesNot) {
  Sensor sensor;
  sensor.until_trip(40.0, 100);
  EXPECT_EQ(sensor.until_trip(55.0, 10).first, Reason::kNone);
  EXPECT_EQ(sensor.until_trip(40.0, 100).first, Reason::kNone);
  EXPECT_TRUE(sensor.check.usable());
  const auto [reason, ticks] = sensor.until_trip(25.0, 100);
  EXPECT_EQ(name(reason), "sensor_jump");
  EXPECT_EQ(ticks, 20);
}

TEST(ThermistorCheck, FourKelvinBetweenTwoReadingsIsNoJump) {
  for (const double c : {44.0, 36.0}) {
    Sensor sensor;
    sensor.until_trip(40.0, 100);
    sensor.step(c);
    EXPECT_TRUE(sensor.check.usable()) << c;
    sensor.until_trip(40.0, 100);
    sensor.step(c + (c > 40.0 ? 0.1 : -0.1));
    EXPECT_FALSE(sensor.check.usable()) << c;
  }
}

TEST(ThermistorCheck, AQuarterOfASecondOldIsUsableAndASecondIsAFault) {
  for (const bool fresh : {true, false}) {
    Sensor sensor;
    sensor.until_trip(40.0, 10);
    sensor.reading.fresh = fresh;
    const auto quarter = [&] { return sensor.check.step(sensor.reading, 0.25); };
    EXPECT_EQ(quarter(), Reason::kNone);
    EXPECT_TRUE(sensor.check.usable());
    EXPECT_EQ(sensor.check.arming_blocker(), Reason::kNone);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(quarter(), Reason::kNone);
    EXPECT_FALSE(sensor.check.usable());
    EXPECT_EQ(quarter(), fresh ? Reason::kSensorStale : Reason::kNone)
        << "without telemetry the fault is the link's";
  }
}

TEST(ThermistorCheck, StaleWhenTheConversionsStop) {
  Sensor sensor;
  sensor.until_trip(40.0, 100);
  sensor.until_trip(40.0, 251, false);
  EXPECT_FALSE(sensor.check.usable());
  EXPECT_EQ(name(sensor.check.arming_blocker()), "sensor_stale");
  const auto [reason, ticks] = sensor.until_trip(40.0, 2000, false);
  EXPECT_EQ(name(reason), "sensor_stale");
  EXPECT_EQ(ticks, 1000 - 251);
}

}  // namespace
}  // namespace hedgehog::control
