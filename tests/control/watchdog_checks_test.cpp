// SPDX-License-Identifier: MIT
// The watchdog's checks one by one: what trips them, after how long, and what does not.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "daemon/control/board_check.h"
#include "daemon/control/current_check.h"
#include "daemon/control/fan_check.h"
#include "daemon/control/heat_check.h"
#include "daemon/control/sensor_check.h"
#include "model/random_stream.h"
#include "model/tick.h"

namespace hedgehog::control {
namespace {

constexpr double kDt = model::kTickSeconds;

/// A thermistor that is read every 10 ms.
class Sensor {
 public:
  Reason step(double sensor_c, bool converts = true) {
    if (converts && ++ticks_ % 10 == 0) ++reading.conversions;
    reading.fresh = true;
    reading.sensor_c = sensor_c;
    return check.step(reading, kDt);
  }
  /// Ticks until a reason, at most `most`.
  std::pair<Reason, int> until_trip(double sensor_c, int most, bool converts = true) {
    for (int i = 1; i <= most; ++i) {
      if (const Reason reason = step(sensor_c, converts); reason != Reason::kNone)
        return {reason, i};
    }
    return {Reason::kNone, most};
  }
  SensorCheck check;
  SensorReading reading;

 private:
  int ticks_ = 0;
};

TEST(SensorCheck, IsNotSaneBeforeItsFirstReading) {
  Sensor sensor;
  EXPECT_EQ(sensor.check.doubt(), Reason::kSensorStale);
  EXPECT_FALSE(sensor.check.usable());
  sensor.step(25.0);
  EXPECT_EQ(sensor.check.doubt(), Reason::kNone);
  EXPECT_TRUE(sensor.check.usable());
}

TEST(SensorCheck, ImplausibleOutsideMinusTwentyToHundredAndTwentyFive) {
  for (const double c : {-20.1, 125.1, std::numeric_limits<double>::quiet_NaN()}) {
    Sensor sensor;
    EXPECT_EQ(sensor.step(c), Reason::kNone);
    EXPECT_FALSE(sensor.check.usable()) << "not used from the first doubt on";
    const auto [reason, ticks] = sensor.until_trip(c, 100);
    EXPECT_EQ(name(reason), "sensor_implausible");
    EXPECT_EQ(ticks, 39);
  }
  for (const double c : {-19.9, 124.9}) {
    Sensor sensor;
    EXPECT_EQ(sensor.until_trip(c, 500).first, Reason::kNone);
  }
}

TEST(SensorCheck, AJumpTripsAfterTwentyMillisecondsOneOddReadingDoesNot) {
  Sensor sensor;
  sensor.until_trip(40.0, 100);
  EXPECT_EQ(sensor.until_trip(55.0, 10).first, Reason::kNone);
  EXPECT_EQ(sensor.until_trip(40.0, 100).first, Reason::kNone);
  EXPECT_TRUE(sensor.check.usable());
  const auto [reason, ticks] = sensor.until_trip(25.0, 100);
  EXPECT_EQ(name(reason), "sensor_jump");
  EXPECT_EQ(ticks, 20);
}

TEST(SensorCheck, StaleWhenTheConversionsStandStill) {
  Sensor sensor;
  sensor.until_trip(40.0, 100);
  sensor.until_trip(40.0, 251, false);
  EXPECT_FALSE(sensor.check.usable());
  EXPECT_EQ(name(sensor.check.doubt()), "sensor_stale");
  const auto [reason, ticks] = sensor.until_trip(40.0, 2000, false);
  EXPECT_EQ(name(reason), "sensor_stale");
  EXPECT_EQ(ticks, 1000 - 251);
}

TEST(SensorCheck, FrozenWhenItsWindingMovedItByFiveKelvin) {
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

TEST(SensorCheck, AFlatReadingOfAFlatWindingIsNoFault) {
  Sensor sensor;
  sensor.reading.measuring = true;
  sensor.reading.winding_c = 60.9;
  EXPECT_EQ(sensor.until_trip(60.9, 100'000).first, Reason::kNone);
}

TEST(SensorCheck, DisagreesEitherWayAfterHalfASecond) {
  for (const double off : {-13.0, 13.0}) {
    Sensor sensor;
    sensor.until_trip(40.0 + off, 100);
    sensor.reading.measuring = true;
    sensor.reading.winding_c = 40.0;
    model::RandomStream random(3);
    Reason reason = Reason::kNone;
    int ticks = 0;
    for (; reason == Reason::kNone && ticks < 60'000; ++ticks) {
      reason = sensor.step(40.0 + off + 0.6 * random.uniform(-1, 1));
    }
    EXPECT_EQ(name(reason), "sensor_disagrees");
    EXPECT_GT(ticks, 500);
  }
}

TEST(SensorCheck, ElevenKelvinOffIsNoFaultYet) {
  Sensor sensor;
  sensor.until_trip(51.0, 100);
  sensor.reading.measuring = true;
  sensor.reading.winding_c = 40.0;
  model::RandomStream random(3);
  for (int i = 0; i < 60'000; ++i)
    ASSERT_EQ(sensor.step(51.0 + 0.6 * random.uniform(-1, 1)), Reason::kNone);
}

/// Real thermistors with lags of 1..3 s on a winding that is driven wildly: never a reason.
TEST(SensorCheck, BelievesEveryRealThermistor) {
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

TEST(CurrentCheck, AnIdleWindingMayCarryHalfAnAmpere) {
  CurrentCheck check{model::CoilModel{}};
  CurrentReading reading;
  reading.consecutive = true;
  reading.current_a = {0.49, -0.49, 0.0};
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(check.step(reading), Reason::kNone);
  reading.current_a = {0.0, 0.0, -0.52};
  int ticks = 1;
  while (check.step(reading) == Reason::kNone && ticks < 100) ++ticks;
  EXPECT_EQ(ticks, 15);
}

TEST(CurrentCheck, FollowsEveryDriveWithLAndROff) {
  for (const double l_off : {0.8, 1.0, 1.2}) {
    for (const double t : {15.0, 70.0}) {
      for (const double hz : {0.5, 10.0, 60.0, 170.0, 250.0}) {
        for (const int delay : {0, 2, 4}) {
          CurrentCheck check{model::CoilModel{}};
          const double r = 0.45 * (1.0 + 0.00393 * (t - 25.0));
          const double keep = std::exp(-r * kDt / (1.5e-3 * l_off));
          std::array<double, 8> volts{};
          double current = 0.0;
          for (int i = 0; i < 5000; ++i) {
            const double phase = std::fmod(i * kDt * hz, 1.0);
            // From one end to the other, as hard as the supply can.
            const double commanded = phase < 0.5 ? 12.0 : (phase < 0.6 ? -12.0 : 0.0);
            volts[static_cast<std::size_t>(i % 8)] = std::clamp(commanded, -7.0, 7.0);
            const double applied = volts[static_cast<std::size_t>((i + 8 - delay) % 8)];
            current = keep * current + (1.0 - keep) * applied / r;
            CurrentReading reading;
            reading.consecutive = true;
            reading.current_a.x = current;
            reading.applied_v.x = applied;
            reading.commanded_v.x = volts[static_cast<std::size_t>(i % 8)];
            ASSERT_EQ(name(check.step(reading)), "none")
                << "L x " << l_off << ", " << t << " C, " << hz << " Hz, delay " << delay;
          }
        }
      }
    }
  }
}

TEST(CurrentCheck, AHalvedMeasurementIsAMismatch) {
  CurrentCheck check{model::CoilModel{}};
  CurrentReading reading;
  reading.consecutive = true;
  reading.applied_v = reading.commanded_v = {2.25, 0, 0};
  Reason reason = Reason::kNone;
  double current = 0.0;
  int ticks = 0;
  for (; reason == Reason::kNone && ticks < 200; ++ticks) {
    reason = check.step(reading);
    current += (5.0 - current) * 0.26;
    reading.current_a.x = 0.5 * current;
  }
  EXPECT_EQ(name(reason), "current_mismatch");
  EXPECT_LT(ticks, 60);
}

// A vibration hides half a measurement from the comparison with what was commanded lately; the
// duty that was applied in that very millisecond shows it.
TEST(CurrentCheck, AHalvedMeasurementOfAVibrationIsAMismatch) {
  CurrentCheck check{model::CoilModel{}};
  CurrentReading reading;
  reading.consecutive = true;
  Reason reason = Reason::kNone;
  double current = 0.0;
  for (int tick = 0; reason == Reason::kNone && tick < 2000; ++tick) {
    reading.applied_v.x = reading.commanded_v.x = tick % 10 < 5 ? 5.0 : 0.0;
    current = 0.728 * current + 0.272 * reading.applied_v.x / 0.476;
    reading.current_a.x = 0.5 * current;
    reason = check.step(reading);
  }
  EXPECT_EQ(name(reason), "current_mismatch");
}

// A board that does something else than it is told, and says so truly.
TEST(CurrentCheck, ADutyThatWasNeverCommandedIsAMismatch) {
  CurrentCheck check{model::CoilModel{}};
  CurrentReading reading;
  reading.consecutive = true;
  reading.commanded_v = {2.25, 0, 0};
  reading.applied_v = {6.75, 0, 0};
  Reason reason = Reason::kNone;
  double current = 0.0;
  int ticks = 0;
  for (; reason == Reason::kNone && ticks < 200; ++ticks) {
    current = 0.728 * current + 0.272 * reading.applied_v.x / 0.476;
    reading.current_a.x = current;
    reason = check.step(reading);
  }
  EXPECT_EQ(name(reason), "current_mismatch");
  EXPECT_LT(ticks, 30);
}

TEST(HeatCheck, AWindingAtSeventyForFiftyMilliseconds) {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    HeatCheck check;
    HeatReading reading;
    reading.electrical = true;
    reading.sensor = true;
    reading.sensor_c = 30.0;
    const auto drive = [&](double celsius) {
      reading.before_a[coil] = reading.after_a[coil] = -5.0;
      reading.voltage_v[coil] = -5.0 * 0.45 * (1.0 + 0.00393 * (celsius - 25.0));
      return check.step(reading, 70.0, kDt);
    };
    for (int i = 0; i < 5000; ++i) ASSERT_EQ(drive(69.5), Reason::kNone);
    EXPECT_NEAR(check.winding_c(coil), 69.5, 1e-6);
    int ticks = 0;
    while (drive(71.0) == Reason::kNone && ticks < 1000) ++ticks;
    EXPECT_LT(ticks, 130);
    EXPECT_GE(ticks, 49);
  }
}

TEST(HeatCheck, TheThermistorAtSeventyForFiftyMilliseconds) {
  HeatCheck check;
  HeatReading reading;
  reading.sensor = true;
  for (int round = 0; round < 100; ++round) {
    reading.sensor_c = 70.5;
    for (int i = 0; i < 40; ++i) ASSERT_EQ(check.step(reading, 70.0, kDt), Reason::kNone);
    reading.sensor_c = 69.5;
    for (int i = 0; i < 40; ++i) ASSERT_EQ(check.step(reading, 70.0, kDt), Reason::kNone);
  }
  reading.sensor_c = 70.0;
  int ticks = 1;
  while (check.step(reading, 70.0, kDt) == Reason::kNone && ticks < 100) ++ticks;
  EXPECT_EQ(ticks, 50);
}

TEST(FanCheck, ThreeSecondsWithoutATurn) {
  FanCheck check;
  for (int i = 0; i < 10'000; ++i) ASSERT_EQ(check.step(0.0, 0.0, kDt), Reason::kNone);
  for (int i = 0; i < 2999; ++i) ASSERT_EQ(check.step(1.0, 0.0, kDt), Reason::kNone);
  EXPECT_EQ(name(check.step(1.0, 0.0, kDt)), "fan_stopped");
  check.reset();
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(check.step(1.0, 0.0, kDt), Reason::kNone);
  check.step(1.0, 400.0, kDt);
  for (int i = 0; i < 2999; ++i) ASSERT_EQ(check.step(1.0, 0.0, kDt), Reason::kNone);
}

TEST(BoardCheck, NamesTheGravestFault) {
  using namespace device;
  EXPECT_EQ(name(reason_of_faults(kFaultDeadMan)), "board_dead_man");
  EXPECT_EQ(name(reason_of_faults(kFaultDeadMan | kFaultBridge)), "bridge_fault");
  EXPECT_EQ(name(reason_of_faults(kFaultBridge | kFaultStuckBridge)), "board_stuck_bridge");
  EXPECT_EQ(name(reason_of_faults(kFaultSensorShort)), "sensor_short");
  EXPECT_EQ(name(reason_of_faults(0)), "none");
  for (int bit = 0; bit < 9; ++bit)
    EXPECT_NE(reason_of_faults(static_cast<std::uint16_t>(1 << bit)), Reason::kNone) << bit;
}

TEST(BoardCheck, AliveUntilAHundredTicksOfSilence) {
  BoardCheck check;
  EXPECT_FALSE(check.alive());
  check.step(true, true, {}, 1);
  EXPECT_TRUE(check.alive());
  for (int i = 0; i < 99; ++i) {
    check.step(true, false, {}, 1);
    ASSERT_TRUE(check.alive()) << i;
  }
  check.step(true, false, {}, 1);
  EXPECT_FALSE(check.alive());
  check.step(false, true, {}, 1);
  EXPECT_FALSE(check.alive()) << "present is a condition of its own";
}

}  // namespace
}  // namespace hedgehog::control
