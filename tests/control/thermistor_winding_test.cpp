// SPDX-License-Identifier: MIT
// The watchdog's comparison of a thermistor with its winding: frozen, or not where a thermistor
// with a lag of 1 to 3 s can be.
#include <gtest/gtest.h>

#include <utility>

#include "model/random_stream.h"
#include "tests/control/thermistor_sensor.h"

namespace hedgehog::control {
namespace {

constexpr double kDt = model::kTickSeconds;

/// A thermistor that reads `sensor_c` while its winding warms by 1 K/s from `winding_c`. Returns
/// the winding's temperature when the thermistor counts as frozen; 0 if not within 30 K.
double warmed_until_frozen(Sensor& sensor, double sensor_c, double winding_c) {
  sensor.reading.measuring = true;
  for (const double end_c = winding_c + 30.0; winding_c < end_c; winding_c += 1.0 * kDt) {
    sensor.reading.winding_c = winding_c;
    const Reason reason = sensor.step(sensor_c);
    if (reason == Reason::kSensorFrozen) return winding_c;
    EXPECT_EQ(name(reason), "none");
  }
  return 0.0;
}
/// At 1 K/s the longest lag, 3 s, has moved by 4.9 K when the winding has by 7.7.
constexpr double kFrozenAfterK = 7.7;

TEST(ThermistorCheck, FrozenWhenItsWindingMovedItByFiveKelvin) {
  for (const double start_c : {30.0, 25.4}) {
    Sensor sensor;
    EXPECT_NEAR(warmed_until_frozen(sensor, start_c, start_c), start_c + kFrozenAfterK, 0.1);
  }
}

TEST(ThermistorCheck, HalfAKelvinIsAMovement) {
  Sensor sensor;
  sensor.until_trip(30.0, 100);
  sensor.reading.measuring = true;
  for (double c = 30.0; c < 35.0; c += 1.0 * kDt) {
    sensor.reading.winding_c = c;
    ASSERT_EQ(name(sensor.step(30.0)), "none");
  }
  EXPECT_NEAR(warmed_until_frozen(sensor, 30.5, 35.0), 40.4, 0.2) << "without it: 37.7";
}

// Also below the freezing point, from where it was last seen to move.
TEST(ThermistorCheck, FrozenAfterItHasMoved) {
  Sensor sensor;
  sensor.reading.measuring = true;
  double winding_c = 0.0;
  double sensor_c = 0.0;
  const auto run = [&](double seconds, double k_per_s) {
    Reason reason = Reason::kNone;
    for (int i = 0; i < seconds * 1000 && reason == Reason::kNone; ++i) {
      winding_c += k_per_s * kDt;
      sensor.reading.winding_c = winding_c;
      reason = sensor.step(sensor_c);
    }
    return reason;
  };
  EXPECT_EQ(run(1.0, 0.0), Reason::kNone);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(run(0.6, 1.0), Reason::kNone);
    sensor_c += 0.5;
  }
  EXPECT_EQ(run(20.0, 0.0), Reason::kNone);
  sensor_c += 0.5;
  EXPECT_EQ(run(1.0, 0.0), Reason::kNone);
  EXPECT_EQ(run(6.0, -1.0), Reason::kNone);
  EXPECT_EQ(run(10.0, 0.0), Reason::kSensorFrozen) << "moved to 3 C, its winding is at -3 C";
}

TEST(ThermistorCheck, NoiseOfTheWindingDelaysFrozenAConstantBiasDoesNot) {
  const auto frozen_after_k = [](double error_k, double bias_k, double later_bias_k) {
    Sensor sensor;
    sensor.reading.winding_error_k = error_k;
    sensor.reading.winding_bias_k = bias_k;
    sensor.until_trip(30.0, 100);
    sensor.reading.measuring = true;
    sensor.reading.winding_c = 30.0;
    EXPECT_EQ(name(sensor.until_trip(30.0, 1000).first), "none");
    sensor.reading.winding_error_k = error_k + later_bias_k - bias_k;
    sensor.reading.winding_bias_k = later_bias_k;
    return warmed_until_frozen(sensor, 30.0, 30.0) - 30.0;
  };
  EXPECT_NEAR(frozen_after_k(2.0, 2.0, 2.0), kFrozenAfterK, 0.1);
  EXPECT_NEAR(frozen_after_k(3.0, 2.0, 2.0), kFrozenAfterK + 1.0, 0.3) << "noise of 1 K";
  EXPECT_NEAR(frozen_after_k(2.0, 2.0, 0.5), kFrozenAfterK + 1.5, 0.3) << "the bias fell";
  EXPECT_NEAR(frozen_after_k(0.5, 0.5, 2.0), kFrozenAfterK + 1.5, 0.3) << "the bias rose";
  EXPECT_NEAR(frozen_after_k(4.0, 0.0, 0.0), kFrozenAfterK + 4.0, 0.3) << "just compared";
  EXPECT_EQ(frozen_after_k(4.01, 0.0, 0.0), -30.0) << "not compared";
}

// Between pulses the winding's last temperature is held for two seconds.
TEST(ThermistorCheck, PulsesWithPausesOfLessThanTwoSecondsShowThatItIsFrozen) {
  for (const auto& [pause_ms, expected] :
       {std::pair{1900, Reason::kSensorFrozen}, {2500, Reason::kNone}}) {
    Sensor sensor;
    sensor.until_trip(30.0, 100);
    sensor.reading.winding_c = 40.0;
    Reason reason = Reason::kNone;
    for (int i = 0; i < 60'000 && reason == Reason::kNone; ++i) {
      sensor.reading.measuring = i % (100 + pause_ms) < 100;
      reason = sensor.step(30.0);
    }
    EXPECT_EQ(name(reason), name(expected)) << pause_ms;
  }
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

TEST(ThermistorCheck, TheErrorOfTheWindingIsAddedToWhatMayDiffer) {
  for (const auto& [off_k, expected] :
       {std::pair{14.5, Reason::kNone}, {16.5, Reason::kSensorDisagrees}}) {
    Sensor sensor;
    sensor.until_trip(30.0, 100);
    sensor.reading.measuring = true;
    sensor.reading.winding_error_k = 3.0;
    sensor.reading.winding_c = 30.0 + off_k;
    Reason reason = Reason::kNone;
    for (int i = 0; i < 60'000 && reason == Reason::kNone; ++i)
      reason = sensor.step(30.0 + 0.6 * (i / 100 % 2));
    EXPECT_EQ(name(reason), name(expected)) << off_k;
  }
}

TEST(ThermistorCheck, AfterALongGapBothLagsAreAtTheWinding) {
  Sensor sensor;
  sensor.until_trip(30.0, 100);
  sensor.reading.measuring = true;
  sensor.reading.winding_c = 40.5;
  sensor.reading.sensor_c = 30.5;
  sensor.reading.since_s = 10.0;
  ++sensor.reading.conversions;
  sensor.check.step(sensor.reading, 10.0);
  EXPECT_EQ(name(sensor.check.arming_blocker()), "none") << "they differ by 10 K";
}

TEST(ThermistorCheck, AfterAStepOfItsWindingItMayLagByOneToThreeSeconds) {
  for (const auto& [lag_s, expected] : {std::pair{0.3, Reason::kSensorDisagrees},
                                        {1.0, Reason::kNone},
                                        {3.0, Reason::kNone},
                                        {8.0, Reason::kSensorDisagrees}}) {
    Sensor sensor;
    double sensor_c = 10.0;
    sensor.until_trip(sensor_c, 100);
    sensor.reading.measuring = true;
    sensor.reading.winding_c = 70.0;
    Reason reason = Reason::kNone;
    for (int i = 0; i < 20'000 && reason == Reason::kNone; ++i) {
      sensor_c += (70.0 - sensor_c) * kDt / lag_s;
      reason = sensor.step(sensor_c);
    }
    EXPECT_EQ(name(reason), name(expected)) << lag_s;
  }
}

/// Ticks for which a thermistor at `sensor_c` whose winding shows `winding_c` is tolerated.
int tolerated_ticks(Sensor& sensor, double sensor_c, double winding_c) {
  sensor.reading.measuring = true;
  sensor.reading.winding_c = winding_c;
  int ticks = 0;
  while (sensor.step(sensor_c + 0.6 * (ticks / 100 % 2)) == Reason::kNone && ticks < 20'000)
    ++ticks;
  return ticks;
}

// After two seconds of a pause what is expected of the thermistor approaches its reading, with a
// time constant of three. At once it would be tolerated for 7.1 s afterwards, with six for 7.9.
TEST(ThermistorCheck, ALongPauseForgetsWhatTheWindingWas) {
  Sensor sensor;
  sensor.until_trip(40.0, 100);
  EXPECT_EQ(tolerated_ticks(sensor, 40.0, 51.5), 20'000);
  sensor.reading.measuring = false;
  EXPECT_EQ(sensor.until_trip(40.0, 8000).first, Reason::kNone);
  EXPECT_NEAR(tolerated_ticks(sensor, 40.0, 26.5), 7434, 100);
}

TEST(ThermistorCheck, ALongPauseForgetsItForTheShortestLagToo) {
  Sensor sensor;
  sensor.until_trip(80.0, 100);
  EXPECT_EQ(tolerated_ticks(sensor, 80.0, 80.0), 20'000);
  sensor.reading.measuring = false;
  for (double c = 80.0; c > 20.0; c -= 2.0 * kDt) ASSERT_EQ(name(sensor.step(c)), "none");
  EXPECT_EQ(sensor.until_trip(20.0, 20'000).first, Reason::kNone);
  EXPECT_NEAR(tolerated_ticks(sensor, 20.0, -20.0), 1600, 60);
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
