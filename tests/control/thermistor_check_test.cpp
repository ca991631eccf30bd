// SPDX-License-Identifier: MIT
// The watchdog's check of the thermistor: trip conditions, their delays, and tolerated readings.
#include "daemon/control/checks/thermistor_check.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "model/random_stream.h"
#include "model/tick.h"

namespace hedgehog::control {
namespace {

constexpr double kDt = model::kTickSeconds;

/// A thermistor that is sampled every 10 ms.
class Sensor {
 public:
  Reason step(double sensor_c, bool converts = true) {
    if (converts && ++ticks_ % 10 == 0) ++reading.conversions;
    reading.fresh = true;
    reading.sensor_c = sensor_c;
    return check.step(reading, kDt);
  }
  /// Ticks until the check returns a reason, at most `max_ticks`.
  std::pair<Reason, int> until_trip(double sensor_c, int max_ticks, bool converts = true) {
    for (int i = 1; i <= max_ticks; ++i)
      if (const Reason reason = step(sensor_c, converts); reason != Reason::kNone)
        return {reason, i};
    return {Reason::kNone, max_ticks};
  }
  ThermistorCheck check;
  SensorReading reading;

 private:
  int ticks_ = 0;
};

TEST(ThermistorCheck, IsNotPlausibleBeforeItsFirstReading) {
  Sensor sensor;
  EXPECT_EQ(sensor.check.arming_blocker(), Reason::kSensorStale);
  EXPECT_FALSE(sensor.check.usable());
  sensor.step(25.0);
  EXPECT_EQ(sensor.check.arming_blocker(), Reason::kNone);
  EXPECT_TRUE(sensor.check.usable());
}

TEST(ThermistorCheck, ImplausibleOutsideMinusTwentyToHundredAndTwentyFive) {
  for (const double c : {-20.1, 125.1, std::numeric_limits<double>::quiet_NaN()}) {
    Sensor sensor;
    EXPECT_EQ(sensor.step(c), Reason::kNone);
    EXPECT_FALSE(sensor.check.usable()) << "not used from the first implausible reading on";
    const auto [reason, ticks] = sensor.until_trip(c, 100);
    EXPECT_EQ(name(reason), "sensor_implausible");
    EXPECT_EQ(ticks, 39);
  }
  for (const double c : {-19.9, 124.9}) {
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

TEST(ThermistorCheck, FrozenWhenItsWindingMovedItByFiveKelvin) {
  Sensor sensor;
  sensor.until_trip(30.0, 100);
  sensor.reading.measuring = true;
  double winding = 30.0;
  Reason reason = Reason::kNone;
  while (reason == Reason::kNone && winding < 60.0) {
    winding += 1.0 * kDt;
    sensor.reading.winding_c = winding;
    reason = sensor.step(30.0);
  }
  EXPECT_EQ(name(reason), "sensor_frozen");
  EXPECT_NEAR(winding, 30.0 + 4.9 + 3.0, 0.5) << "4.9 K and the longest lag at 1 K/s";
}

TEST(ThermistorCheck, AFlatReadingOfAFlatWindingIsNoFault) {
  Sensor sensor;
  sensor.reading.measuring = true;
  sensor.reading.winding_c = 60.9;
  EXPECT_EQ(sensor.until_trip(60.9, 100'000).first, Reason::kNone);
}

TEST(ThermistorCheck, DisagreesEitherWayAfterHalfASecond) {
  for (const double off : {-13.0, 13.0}) {
    Sensor sensor;
    sensor.until_trip(40.0 + off, 100);
    sensor.reading.measuring = true;
    sensor.reading.winding_c = 40.0;
    model::RandomStream random(3);
    Reason reason = Reason::kNone;
    int ticks = 0;
    for (; reason == Reason::kNone && ticks < 60'000; ++ticks)
      reason = sensor.step(40.0 + off + 0.6 * random.uniform(-1, 1));
    EXPECT_EQ(name(reason), "sensor_disagrees");
    EXPECT_GT(ticks, 500);
  }
}

TEST(ThermistorCheck, ElevenKelvinOffIsNoFaultYet) {
  Sensor sensor;
  sensor.until_trip(51.0, 100);
  sensor.reading.measuring = true;
  sensor.reading.winding_c = 40.0;
  model::RandomStream random(3);
  for (int i = 0; i < 60'000; ++i)
    ASSERT_EQ(sensor.step(51.0 + 0.6 * random.uniform(-1, 1)), Reason::kNone);
}

/// Real thermistors with lags of 1..3 s on a winding with a wildly changing load: never a reason.
TEST(ThermistorCheck, AcceptsEveryRealThermistor) {
  for (const double lag : {1.0, 2.0, 3.0}) {
    model::RandomStream random(static_cast<std::uint64_t>(lag * 10));
    Sensor sensor;
    double winding = 25.0;
    double body = 25.0;
    double rate = 0.0;
    for (int i = 0; i < 600'000; ++i) {
      if (i % 3000 == 0) {
        sensor.reading.measuring = random.uniform(0, 1) < 0.6;
        rate = sensor.reading.measuring ? random.uniform(0.0, 2.9) : -(winding - 25.0) / 20.0;
        if (winding > 68.0) rate = -1.0;
      }
      winding += rate * kDt;
      body += (winding - body) * kDt / lag;
      sensor.reading.winding_c = winding;
      ASSERT_EQ(name(sensor.step(body + 0.15 * random.gaussian())), "none") << i;
    }
  }
}

}  // namespace
}  // namespace hedgehog::control
