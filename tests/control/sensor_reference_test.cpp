// SPDX-License-Identifier: MIT
// Checks of the watchdog on readings that drift, jump, stop and resume, tick by tick, against
// `reference/*.tsv`. The other tests specify the required behaviour; these record the actual one,
// so that a changed comparison, constant or sign is detected and must be intended.
// HEDGEHOG_WRITE_REFERENCE=1 rewrites the figures.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "daemon/control/checks/fan_check.h"
#include "daemon/control/checks/thermistor_check.h"
#include "daemon/control/checks/thermometer_check.h"
#include "tests/control/check_outcomes.h"
#include "tests/folders.h"

namespace hedgehog::control {
namespace {

using model::RandomStream;
using rig::ReferenceRecord;

TEST(SensorReference, Sensor) {
  ReferenceRecord record;
  for (int row = 0; row < kReferenceRows; ++row) {
    RandomStream random(static_cast<std::uint64_t>(row) + 1);
    ThermistorCheck check;
    SensorReading reading;
    Outcomes out;
    double winding_c = 30.0;
    double slope_k = 0.0;
    bool follows = true;
    for (int tick = 0; tick < 5 * kReferenceTicks; ++tick) {
      if (tick % 250 == 0) {
        slope_k = one_of(random, 0.0, 0.01, -0.008, 0.03);
        follows = row % 3 != 1;
        reading.open = row % 8 == 5 && bernoulli(random, 0.2);
        reading.shorted = row % 8 == 6 && bernoulli(random, 0.2);
        reading.measuring = row % 3 == 1 || bernoulli(random, 0.7);
        reading.winding_bias_k = random.uniform(0.0, row % 3 == 1 ? 0.6 : 2.0);
        reading.winding_error_k = reading.winding_bias_k + random.uniform(0.0, 2.5);
        if (row % 6 == 2 && bernoulli(random, 0.3)) reading.sensor_c += random.uniform(-9.0, 9.0);
        if (row % 12 == 3 && bernoulli(random, 0.2))
          reading.sensor_c = one_of(random, -20.0, 125.0, -21.0, 126.0);
      }
      winding_c = std::clamp(winding_c + slope_k, 20.0, 75.0);
      reading.winding_c = winding_c + 0.1 * random.gaussian();
      if (follows) reading.sensor_c += (winding_c - reading.sensor_c) * kReferenceDtS / 1.7;
      reading.fresh = row % 4 != 3 || bernoulli(random, 0.6);
      reading.since_s = reading.fresh ? kReferenceDtS : 3.0 * kReferenceDtS;
      const bool stale = row % 5 == 4 && tick / 1100 % 2 == 1;
      if (tick % 10 == 0 && !stale) ++reading.conversions;
      out.add(check.step(reading, kReferenceDtS), check.arming_blocker());
      out.add("usable", check.usable() ? 1.0 : 0.0);
      out.add("age_s", check.age_s());
    }
    record.add(std::to_string(row), out.figures());
  }
  EXPECT_EQ(record.differences(source_folder() + "/tests/control/reference/thermistor_check.tsv"),
            "");
}

TEST(SensorReference, Thermometer) {
  ReferenceRecord record;
  for (int row = 0; row < kReferenceRows; ++row) {
    RandomStream random(static_cast<std::uint64_t>(row) + 401);
    ThermometerCheck check(row % 2 == 0 ? device::ThermometerRole::kCoil
                                        : device::ThermometerRole::kShell);
    ThermometerReading reading;
    Outcomes out;
    double shown_c = 30.0;
    double slope_k = 0.0;
    constexpr int kTicksEach = 20;
    for (int tick = 0; tick < 4 * kReferenceTicks; ++tick) {
      if (tick % 200 == 0) {
        slope_k = one_of(random, 0.0, 0.1, 0.3, -0.2);
        reading.sensor = bernoulli(random, 0.8);
        if (row % 6 == 3 && bernoulli(random, 0.2))
          shown_c = one_of(random, -40.0, 125.0, -41.0, 126.0);
        if (row % 6 == 4) reading.sensor_c = shown_c + random.uniform(-14.0, 14.0);
        reading.sample.present = row % 6 != 5 || bernoulli(random, 0.7);
      }
      shown_c = std::clamp(shown_c + slope_k, -45.0, 130.0);
      if (row % 6 != 4) reading.sensor_c += (shown_c - reading.sensor_c) * 0.01;
      reading.now += kTicksEach;
      if (row % 5 != 2 || tick / 100 % 5 != 3) {
        reading.sample.stamp = reading.now - random.bits() % 600;
        reading.sample.celsius = shown_c;
      }
      out.add(check.step(reading, kTicksEach * kReferenceDtS), check.arming_blocker());
      out.add("known", check.known() ? 1.0 : 0.0);
      out.add("fresh", check.fresh() ? 1.0 : 0.0);
      out.add("warm", check.too_warm_to_arm() ? 1.0 : 0.0);
    }
    record.add(std::to_string(row), out.figures());
  }
  EXPECT_EQ(record.differences(source_folder() + "/tests/control/reference/thermometer_check.tsv"),
            "");
}

TEST(SensorReference, Fan) {
  ReferenceRecord record;
  for (int row = 0; row < kReferenceRows; ++row) {
    RandomStream random(static_cast<std::uint64_t>(row) + 501);
    FanCheck check(7200.0);
    FanReading reading;
    Outcomes out;
    for (int tick = 0; tick < 10 * kReferenceTicks; ++tick) {
      if (tick % 700 == 0) {
        reading.duty = one_of(random, 0.0, 0.89, 0.9, 1.0, 1.0, 1.0);
        reading.rpm = one_of(random, 0.0, 299.0, 5039.0, 5040.0, 7200.0, 7200.0, 10800.0, 10801.0);
      }
      reading.fresh = row % 3 != 2 || tick / 80 % 3 != 1;
      constexpr double kSlow = 3.0;
      check.follow(reading, kSlow * kReferenceDtS);
      out.add(reading.fresh ? check.step(reading.duty > 0.0, reading.rpm, kSlow * kReferenceDtS)
                            : Reason::kNone);
      out.add("cooling", check.cooling() ? 1.0 : 0.0);
      out.add("works", check.works() ? 1.0 : 0.0);
      out.add("standing", check.stalled() ? 1.0 : 0.0);
    }
    record.add(std::to_string(row), out.figures());
  }
  EXPECT_EQ(record.differences(source_folder() + "/tests/control/reference/fan_check.tsv"), "");
}

}  // namespace
}  // namespace hedgehog::control
