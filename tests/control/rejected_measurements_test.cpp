// SPDX-License-Identifier: MIT
// Which measurements the estimate rejects, and the events about it.
#include "daemon/control/checks/rejected_measurements.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "daemon/control/event_reporter.h"

namespace hedgehog::control {
namespace {

constexpr double kAmbientC = 25.0;
constexpr int kWindowTicks = 100;

class RejectedMeasurementsTest : public testing::Test {
 protected:
  RejectedMeasurementsTest() : observer_(model::CoilModel{}, model::ThermalModel{}, start()) {
    for (std::size_t i = 0; i < model::kCoils; ++i) {
      measurement_.thermistors.valid[i] = true;
      measurement_.thermistors.celsius[i] = kAmbientC;
    }
  }
  static model::ThermalStart start() {
    model::ThermalStart start;
    start.nodes.winding_c.fill(kAmbientC);
    start.nodes.core_c = kAmbientC;
    start.ambient_c = kAmbientC;
    start.known = true;
    return start;
  }
  double& thermistor_c(int coil) {
    return measurement_.thermistors.celsius[static_cast<std::size_t>(coil)];
  }
  void run_windows(int windows) {
    for (int tick = 0; tick < windows * kWindowTicks; ++tick) {
      observer_.step(measurement_);
      rejected_.step(observer_);
      ++now_;
      EventList events;
      ReportInputs inputs{.tick = now_, .rejected = rejected_.rejected(), .last_trip = trip_};
      reporter_.report_changes(inputs, events);
      for (const Event& event : events) events_.push_back(event);
    }
  }
  /// Two healthy windows, then some in which the thermistor of `coil` reads 40 K too high.
  void run_with_thermistor_off(int coil, int windows) {
    run_windows(2);
    thermistor_c(coil) = kAmbientC + 40.0;
    run_windows(windows);
  }
  static int thermistor_of(int coil) { return 2 * coil + 1; }

  model::ThermalObserver observer_;
  model::ThermalMeasurement measurement_;
  RejectedMeasurements rejected_;
  EventReporter reporter_;
  Trip trip_;
  model::Tick now_ = 0;
  std::vector<Event> events_;
};

TEST_F(RejectedMeasurementsTest, HealthyOnesAreAllAccepted) {
  run_windows(50);
  EXPECT_EQ(rejected_.rejected(), RejectedSet{});
  EXPECT_TRUE(events_.empty());
}

TEST_F(RejectedMeasurementsTest, OneWindowOutsideTheGateIsNone) {
  run_with_thermistor_off(1, 1);
  thermistor_c(1) = kAmbientC;
  run_windows(5);
  EXPECT_TRUE(events_.empty());
}

TEST_F(RejectedMeasurementsTest, AThermistorIsNamedAfterTwoWindowsAndOncePerRejection) {
  run_with_thermistor_off(1, 1);
  EXPECT_FALSE(rejected_.rejected().contains(thermistor_of(1)));
  run_windows(3);
  EXPECT_TRUE(rejected_.rejected().contains(thermistor_of(1)));
  ASSERT_EQ(events_.size(), 1u);
  EXPECT_EQ(events_[0].type, EventType::kMeasurementRejected);
  EXPECT_EQ(events_[0].tick, 4 * kWindowTicks);
  EXPECT_EQ(events_[0].disagreement,
            Disagreement(1, Quantity::kThermistor, Quantity::kHeatBalance));
}

TEST_F(RejectedMeasurementsTest, ItIsAcceptedAgainAfterTwoSecondsWithinTheGate) {
  run_with_thermistor_off(2, 3);
  thermistor_c(2) = kAmbientC;
  run_windows(19);
  EXPECT_TRUE(rejected_.rejected().contains(thermistor_of(2)));
  run_windows(1);
  EXPECT_FALSE(rejected_.rejected().contains(thermistor_of(2)));
  ASSERT_EQ(events_.size(), 2u);
  EXPECT_EQ(events_[1].type, EventType::kMeasurementAccepted);
  EXPECT_EQ(events_[1].disagreement,
            Disagreement(2, Quantity::kThermistor, Quantity::kHeatBalance));
}

TEST_F(RejectedMeasurementsTest, AWindowOutsideTheGateBeginsTheTwoSecondsAnew) {
  run_with_thermistor_off(0, 2);
  for (int i = 0; i < 5; ++i) {
    thermistor_c(0) = kAmbientC;
    run_windows(19);
    thermistor_c(0) = kAmbientC + 40.0;
    run_windows(1);
  }
  EXPECT_EQ(events_.size(), 1u);
}

TEST_F(RejectedMeasurementsTest, TimeWithoutTheMeasurementCountsForNeither) {
  run_with_thermistor_off(0, 1);
  measurement_.thermistors.valid[0] = false;
  run_windows(50);
  EXPECT_TRUE(events_.empty());
  measurement_.thermistors.valid[0] = true;
  run_windows(1);
  ASSERT_EQ(events_.size(), 1u);
  measurement_.thermistors.valid[0] = false;
  run_windows(50);
  EXPECT_EQ(events_.size(), 1u);
}

TEST_F(RejectedMeasurementsTest, WhileTheEstimateSettlesNoneCounts) {
  model::ThermalStart unknown = start();
  unknown.known = false;
  observer_ = model::ThermalObserver(model::CoilModel{}, model::ThermalModel{}, unknown);
  thermistor_c(1) = kAmbientC + 150.0;
  ASSERT_TRUE(observer_.settling());
  run_windows(150);
  EXPECT_TRUE(events_.empty());
}

TEST_F(RejectedMeasurementsTest, AnotherEstimateRejectsNoneWithoutAnEvent) {
  run_with_thermistor_off(1, 3);
  ASSERT_EQ(events_.size(), 1u);
  rejected_ = RejectedMeasurements();
  reporter_.clear_measurements();
  thermistor_c(1) = kAmbientC;
  run_windows(30);
  EXPECT_EQ(events_.size(), 1u);
}

TEST_F(RejectedMeasurementsTest, VIOfAWindingIsNamedAsItsResistance) {
  for (int coil = 0; coil < model::kCoils; ++coil) {
    observer_ = model::ThermalObserver(model::CoilModel{}, model::ThermalModel{}, start());
    rejected_ = RejectedMeasurements();
    reporter_.clear_measurements();
    events_.clear();
    model::Vec3 current_a;
    current_a[coil] = 3.0;
    const double ohm = model::CoilModel{}.r25_ohm[static_cast<std::size_t>(coil)];
    measurement_.electrical_valid = true;
    measurement_.supply_v = 12.0;
    measurement_.current_a = measurement_.current_before_a = current_a;
    measurement_.voltage_v = ohm * current_a;
    run_windows(10);
    ASSERT_TRUE(events_.empty());
    measurement_.voltage_v = 1.5 * ohm * current_a;
    run_windows(10);
    ASSERT_EQ(events_.size(), 1u) << coil;
    EXPECT_EQ(events_[0].disagreement,
              Disagreement(coil, Quantity::kResistance, Quantity::kHeatBalance));
  }
}

TEST(RejectedSet, NamesEachSourceOnce) {
  for (int i = 0; i < RejectedSet::kSources; ++i) {
    RejectedSet set;
    set.set(i, true);
    for (int k = 0; k < RejectedSet::kSources; ++k) {
      EXPECT_EQ(set.contains(k), k == i);
      EXPECT_EQ(RejectedSet::source(k) == RejectedSet::source(i), k == i);
    }
    EXPECT_EQ(RejectedSet::source(i).coil(), i / 2);
    set.set(i, false);
    EXPECT_EQ(set, RejectedSet{});
  }
}

}  // namespace
}  // namespace hedgehog::control
