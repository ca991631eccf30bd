// SPDX-License-Identifier: MIT
// Checks of the watchdog on readings that drift, jump, stop and resume, tick by tick, against
// `reference/*.tsv`. The other tests specify the required behaviour; these record the actual one,
// so that a changed comparison, constant or sign is detected and must be intended.
// HEDGEHOG_WRITE_REFERENCE=1 rewrites the figures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "daemon/control/checks/current_check.h"
#include "daemon/control/checks/over_temperature_check.h"
#include "daemon/control/checks/supply_balance.h"
#include "tests/control/check_outcomes.h"
#include "tests/folders.h"

namespace hedgehog::control {
namespace {

using model::RandomStream;
using rig::ReferenceRecord;

TEST(ElectricalReference, Current) {
  ReferenceRecord record;
  for (int row = 0; row < 2 * kReferenceRows; ++row) {
    RandomStream random(static_cast<std::uint64_t>(row) + 101);
    model::CoilModel coils;
    CurrentCheck check(coils);
    CurrentReading reading;
    Outcomes out;
    model::Vec3 true_a;
    double gain = 1.0;
    int faulty_coil = 0;
    for (int tick = 0; tick < kReferenceTicks; ++tick) {
      if (tick % 40 == 0) {
        for (int coil = 0; coil < model::kCoils; ++coil)
          reading.commanded_v[coil] = one_of(random, 0.0, 0.0, 2.0, -4.0, 6.0, 0.1);
        reading.held_v = 0.9 * reading.commanded_v;
        faulty_coil = static_cast<int>(random.bits() % 3);
        gain = row % 2 == 0 ? 1.0 : one_of(random, 1.0, 1.0, 1.3, 0.6, 0.75);
        if (row % 3 == 2)
          reading.measured[static_cast<std::size_t>(faulty_coil)] = bernoulli(random, 0.5);
      }
      reading.skipped = row % 4 == 3 && bernoulli(random, 0.02) ? random.bits() % 130 : 0;
      reading.applied_v = reading.commanded_v;
      if (row % 6 == 5) reading.applied_v[faulty_coil] = 0.5 * reading.commanded_v[faulty_coil];
      for (int coil = 0; coil < model::kCoils; ++coil)
        true_a[coil] += (reading.applied_v[coil] / 0.475 - true_a[coil]) * 0.27;
      reading.current_a = true_a;
      reading.current_a[faulty_coil] *= gain;
      if (row % 8 == 1) reading.current_a[faulty_coil] += one_of(random, 0.0, 0.45, 0.55, 1.2);
      reading.fresh = row % 5 != 4 || bernoulli(random, 0.7);
      reading.follows = reading.fresh && (row % 5 != 4 || bernoulli(random, 0.8));
      reading.since_s = reading.fresh ? kReferenceDtS : 2.0 * kReferenceDtS;
      out.add(check.step(reading));
      out.add("pending", check.pending() ? 1.0 : 0.0);
      for (int coil = 0; coil < model::kCoils; ++coil)
        out.add(std::string("commanded_a_") + "xyz"[coil], check.commanded_a()[coil]);
    }
    record.add(std::to_string(row), out.figures());
  }
  EXPECT_EQ(record.differences(source_folder() + "/tests/control/reference/current_check.tsv"), "");
}

TEST(ElectricalReference, Heat) {
  ReferenceRecord record;
  for (int row = 0; row < kReferenceRows; ++row) {
    RandomStream random(static_cast<std::uint64_t>(row) + 201);
    model::ThermalModel thermal;
    thermal.sensor_winding = row % 3;
    OverTemperatureCheck check(model::CoilModel{}, thermal);
    if (row % 2 == 0) check.start_rested();
    HeatReading reading;
    reading.accuracy = row % 5 == 3 ? model::kDriverCsAccuracy : model::kInLineAccuracy;
    Outcomes out;
    double shown_c = 30.0;
    double slope_k = 0.0;
    model::Vec3 target_a;
    model::Vec3 current_a;
    for (int tick = 0; tick < 3 * kReferenceTicks; ++tick) {
      if (tick % 150 == 0) {
        for (int coil = 0; coil < model::kCoils; ++coil)
          target_a[coil] = one_of(random, 0.0, 1.4, 1.6, 5.0, -8.0, 12.0);
        slope_k = one_of(random, 0.0, 0.05, 0.12, -0.05, -0.2);
        for (std::size_t i = 0; i < 3; ++i) {
          reading.thermistors.valid[i] = row % 4 != 1 || bernoulli(random, 0.6);
          reading.thermistors.celsius[i] = random.uniform(24.0, row % 6 == 5 ? 72.0 : 50.0);
          reading.measured[i] = row % 5 != 3 || bernoulli(random, 0.8);
        }
      }
      shown_c = std::clamp(shown_c + slope_k, -15.0, 85.0);
      const double ohm = model::resistance_at(model::Ohms(0.45), model::Celsius(shown_c)).value;
      reading.before_a = current_a;
      // Every fourth row is a vibration, whose current changes continuously.
      const double wave = row % 4 == 3 ? std::sin(0.4 * tick) : 1.0;
      for (int coil = 0; coil < model::kCoils; ++coil) {
        const double before_a = current_a[coil];
        current_a[coil] += 0.27 * (wave * target_a[coil] - before_a);
        reading.voltage_v[coil] = ohm * 0.5 * (before_a + current_a[coil]) +
                                  1.4e-3 * (current_a[coil] - before_a) / kReferenceDtS;
        reading.after_a[coil] = current_a[coil] + 0.02 * random.gaussian();
      }
      reading.electrical = row % 7 != 6 || bernoulli(random, 0.7);
      reading.fresh = row % 7 != 6 || bernoulli(random, 0.9);
      reading.since_s = reading.fresh ? kReferenceDtS : 2.0 * kReferenceDtS;
      out.add(check.step(reading, 70.0, kReferenceDtS));
      for (int coil = 0; coil < model::kCoils; ++coil) {
        const std::string axis(1, "xyz"[coil]);
        out.add("measuring_" + axis, check.measuring(coil) ? 1.0 : 0.0);
        out.add("winding_c_" + axis, check.winding_c(coil));
        out.add("error_k_" + axis,
                check.measuring(coil) ? check.noise_k(coil) + check.bias_k(coil) : 0.0);
        out.add("file_k_" + axis, check.file_k(coil));
      }
    }
    record.add(std::to_string(row), out.figures());
  }
  EXPECT_EQ(
      record.differences(source_folder() + "/tests/control/reference/over_temperature_check.tsv"),
      "");
}

TEST(ElectricalReference, SupplyBalance) {
  ReferenceRecord record;
  for (int row = 0; row < kReferenceRows; ++row) {
    RandomStream random(static_cast<std::uint64_t>(row) + 301);
    SupplyBalance balance(12.0);
    SupplyReading reading;
    reading.accuracy = row % 3 == 2 ? model::kDriverCsAccuracy : model::kInLineAccuracy;
    Outcomes out;
    double gain = 1.0;
    for (int tick = 0; tick < 14 * kReferenceTicks; ++tick) {
      if (tick % 200 == 0)
        for (int coil = 0; coil < model::kCoils; ++coil)
          reading.duty[coil] = one_of(random, 0.0, 0.1, 0.3, -0.2, 0.5);
      if (tick == 10 * kReferenceTicks)
        gain = row % 2 == 0 ? 1.0 : one_of(random, 0.9, 1.04, 1.1, 0.95);
      double drawn_a = 0.05;
      for (int coil = 0; coil < model::kCoils; ++coil) {
        const double a = reading.duty[coil] * 12.0 / 0.47;
        drawn_a += reading.duty[coil] * a;
        reading.current_a[coil] = (coil == row % 3 ? gain : 1.0) * a + 0.02 * random.gaussian();
      }
      reading.known = row % 4 != 3 || bernoulli(random, 0.7);
      reading.supply_v =
          (row % 6 == 4 && tick > 11 * kReferenceTicks ? 0.94 : 1.0) * (12.0 - 0.02 * drawn_a);
      reading.supply_current_a = drawn_a + 0.02 * random.gaussian();
      const Disagreement found = balance.step(reading, kReferenceDtS);
      out.add(found.any() ? Reason::kMeasurementsDisagree : Reason::kNone);
      if (tick % 20 != 0) continue;
      for (int coil = 0; coil < model::kCoils; ++coil) {
        const std::string axis(1, "xyz"[coil]);
        out.add("coil", found.any() ? found.coil() + 1.0 : 0.0);
        out.add("gain_" + axis, balance.gain(coil));
        out.add("deviation_" + axis, balance.gain_deviation(coil));
        for (const double share : {-0.1, -0.02, 0.03}) {
          for (const auto since : {SupplyBalance::Since::kStart, SupplyBalance::Since::kFile}) {
            const Disagreement moved = balance.moved(coil, share, since);
            for (int q = 0; q < kQuantities; ++q)
              out.add("moved_" + axis, moved.has(static_cast<Quantity>(q)) ? q + 1.0 : 0.0);
          }
        }
      }
    }
    record.add(std::to_string(row), out.figures());
  }
  EXPECT_EQ(record.differences(source_folder() + "/tests/control/reference/supply_balance.tsv"),
            "");
}

}  // namespace
}  // namespace hedgehog::control
