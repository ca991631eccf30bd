// SPDX-License-Identifier: MIT
// The second thermometer: readings that stop the ball, and after what time.
#include "daemon/control/checks/thermometer_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/limit/shell_limit.h"

namespace hedgehog::control {
namespace {

using device::ThermometerRole;

struct Probe {
  explicit Probe(ThermometerRole role) : check(role) {
    reading.sample.present = true;
    reading.sample.celsius = 25.0;
    reading.sensor = true;
  }
  ThermometerCheck check;
  ThermometerReading reading;

  Reason step() {
    ++reading.now;
    reading.sample.stamp = reading.now;
    return check.step(reading, model::kTickSeconds);
  }
  /// Ticks until it trips; 0: not within ten seconds.
  int trips_after(Reason& reason) {
    for (int tick = 1; tick <= 10'000; ++tick) {
      reason = step();
      if (reason != Reason::kNone) return tick;
    }
    return 0;
  }
};

TEST(ThermometerCheck, AMissingThermometerIsNoFault) {
  ThermometerCheck check(ThermometerRole::kNone);
  EXPECT_EQ(check.step({}, model::kTickSeconds), Reason::kNone);
  EXPECT_EQ(check.arming_blocker(), Reason::kNone);
  EXPECT_FALSE(check.known());
}

TEST(ThermometerCheck, IsLostAfterFiveSecondsOfSilence) {
  for (const auto role : {ThermometerRole::kShell, ThermometerRole::kCoil}) {
    Probe probe(role);
    EXPECT_EQ(probe.step(), Reason::kNone);
    EXPECT_TRUE(probe.check.known());
    EXPECT_EQ(probe.check.celsius(), 25.0);
    probe.reading.now += 5000;
    EXPECT_EQ(probe.check.step(probe.reading, model::kTickSeconds), Reason::kNone);
    ++probe.reading.now;
    EXPECT_EQ(probe.check.step(probe.reading, model::kTickSeconds), Reason::kThermometerLost);
    EXPECT_EQ(probe.check.arming_blocker(), Reason::kThermometerLost);
    EXPECT_FALSE(probe.check.known());
    EXPECT_EQ(probe.step(), Reason::kNone) << "it answers again";
    EXPECT_EQ(probe.check.arming_blocker(), Reason::kNone);
    probe.reading.sample.present = false;
    EXPECT_EQ(probe.step(), Reason::kThermometerLost);
  }
}

TEST(ThermometerCheck, ValuesOutsideTheRangeOfProbesAreNoReading) {
  Probe probe(ThermometerRole::kShell);
  for (const double possible_c : {-40.0, 0.0, 47.0}) {
    probe.reading.sample.celsius = possible_c;
    EXPECT_EQ(probe.step(), Reason::kNone) << possible_c;
  }
  for (const double impossible_c : {-40.1, 125.1, std::nan("")}) {
    probe.reading.sample.celsius = impossible_c;
    EXPECT_EQ(probe.step(), Reason::kThermometerLost) << impossible_c;
  }
  probe.reading.sample.celsius = 125.0;
  EXPECT_EQ(probe.step(), Reason::kNone) << "hot, not lost";
  EXPECT_EQ(probe.check.arming_blocker(), Reason::kShellHot);
}

TEST(ThermometerCheck, AShellAtItsLimitForOneAndAHalfSecondsTrips) {
  Reason reason{};
  Probe probe(ThermometerRole::kShell);
  probe.reading.sample.celsius = model::kShellTripC - 0.01;
  EXPECT_EQ(probe.trips_after(reason), 0);
  EXPECT_EQ(probe.check.arming_blocker(), Reason::kNone);
  probe.reading.sample.celsius = model::kShellTripC;
  EXPECT_EQ(probe.trips_after(reason), 1500);
  EXPECT_EQ(reason, Reason::kShellHot);
  EXPECT_EQ(probe.check.arming_blocker(), Reason::kShellHot);
}

TEST(ThermometerCheck, ACoilAtTheTripTemperatureForOneAndAHalfSecondsIsOverheated) {
  Reason reason{};
  Probe probe(ThermometerRole::kCoil);
  probe.reading.sensor_c = 62.0;
  probe.reading.sample.celsius = 69.99;
  EXPECT_EQ(probe.trips_after(reason), 0);
  probe.reading.sample.celsius = 70.0;
  EXPECT_EQ(probe.trips_after(reason), 1500);
  EXPECT_EQ(reason, Reason::kOverheated);
}

TEST(ThermometerCheck, ACoilTenKelvinsFromItsThermistorForFiveSecondsDisagrees) {
  for (const double sign : {1.0, -1.0}) {
    Reason reason{};
    Probe probe(ThermometerRole::kCoil);
    probe.reading.sample.celsius = 25.0 + sign * 10.0;
    EXPECT_EQ(probe.trips_after(reason), 0);
    EXPECT_EQ(probe.check.arming_blocker(), Reason::kNone);
    probe.reading.sample.celsius = 25.0 + sign * 10.01;
    EXPECT_EQ(probe.trips_after(reason), 5000);
    EXPECT_EQ(reason, Reason::kThermometerDisagrees);
    EXPECT_EQ(probe.check.arming_blocker(), Reason::kThermometerDisagrees);
  }
}

// After a step of the thermistor from 25 to 55 C a probe's reading may lie between those with a lag
// of 1 s and of 40 s, extended by 10 K on both sides.
TEST(ThermometerCheck, AProbeMayLagByOneToFortySeconds) {
  const double after_s = 3.0;
  for (const double lag_s : {1.0, 40.0}) {
    Probe probe(ThermometerRole::kCoil);
    probe.step();
    probe.reading.sensor_c = 55.0;
    const double lagging_c = 55.0 - 30.0 * std::pow(1.0 - model::kTickSeconds / lag_s, 3000);
    for (int tick = 0; tick < static_cast<int>(after_s / model::kTickSeconds); ++tick) {
      probe.reading.sample.celsius = lagging_c;
      probe.step();
    }
    const double out = lag_s == 1.0 ? 1.0 : -1.0;
    probe.reading.sensor = false;  // freezes the permitted range
    probe.reading.sample.celsius = lagging_c + out * 9.99;
    probe.step();
    EXPECT_EQ(probe.check.arming_blocker(), Reason::kNone) << lag_s;
    probe.reading.sample.celsius = lagging_c + out * 10.01;
    probe.step();
    EXPECT_EQ(probe.check.arming_blocker(), Reason::kThermometerDisagrees) << lag_s;
  }
}

TEST(ThermometerCheck, WithoutAPlausibleThermistorNothingDisagrees) {
  Reason reason{};
  Probe probe(ThermometerRole::kCoil);
  probe.reading.sensor = false;
  probe.reading.sample.celsius = 60.0;
  EXPECT_EQ(probe.trips_after(reason), 0);
  probe.reading.sensor = true;
  probe.reading.sensor_c = 60.0;
  EXPECT_EQ(probe.trips_after(reason), 0) << "followed from its first reading";
}

TEST(ThermometerCheck, AfterALongGapFollowsTheThermistorAtOnce) {
  Probe probe(ThermometerRole::kCoil);
  probe.step();
  probe.reading.sensor_c = probe.reading.sample.celsius = 60.0;
  ++probe.reading.now;
  probe.reading.sample.stamp = probe.reading.now;
  probe.check.step(probe.reading, 100.0);
  EXPECT_EQ(probe.check.arming_blocker(), Reason::kNone);
  for (const double disagreeing_c : {49.0, 71.0}) {
    probe.reading.sample.celsius = disagreeing_c;
    probe.step();
    EXPECT_EQ(probe.check.arming_blocker(), Reason::kThermometerDisagrees) << disagreeing_c;
  }
}

TEST(ThermometerCheck, ABallMayBeArmedUpToTheShellTemperatureOfNoCurrent) {
  Probe probe(ThermometerRole::kShell);
  EXPECT_TRUE(probe.check.too_warm_to_arm()) << "not known yet";
  probe.reading.sample.celsius = model::kShellZeroC;
  probe.step();
  EXPECT_FALSE(probe.check.too_warm_to_arm());
  probe.reading.sample.celsius = model::kShellZeroC + 0.01;
  probe.step();
  EXPECT_TRUE(probe.check.too_warm_to_arm());
  EXPECT_FALSE(Probe(ThermometerRole::kCoil).check.too_warm_to_arm());
}

}  // namespace
}  // namespace hedgehog::control
