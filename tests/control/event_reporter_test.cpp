// SPDX-License-Identifier: MIT
// Reports of lost and restored orientation.
#include "daemon/control/event_reporter.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hedgehog::control {
namespace {

class OrientationEvents : public testing::Test {
 protected:
  /// Runs `ticks` in which the orientation is `fresh`, one every `stride` milliseconds.
  void run(int ticks, bool fresh, model::Tick stride = 1) {
    for (int i = 0; i < ticks; ++i) {
      tick_ += stride;
      ReportInputs inputs{.tick = tick_,
                          .orientation_present = true,
                          .orientation_fresh = fresh,
                          .last_trip = trip_};
      EventList events;
      reporter_.report_changes(inputs, events);
      for (const Event& event : events) reported_.emplace_back(name(event.type));
    }
  }
  using Names = std::vector<std::string>;

  Names reported_;

 private:
  EventReporter reporter_;
  Trip trip_;
  model::Tick tick_ = 0;
};

TEST_F(OrientationEvents, TheFirstIsReportedAtOnceAndALossAfterFiftyMilliseconds) {
  run(1, true);
  EXPECT_EQ(reported_, Names{"orientation_restored"});
  run(50, false);
  EXPECT_EQ(reported_.size(), 1u);
  run(1, false);
  EXPECT_EQ(reported_.back(), "orientation_lost");
}

TEST_F(OrientationEvents, AnOccasionalGapIsNoLoss) {
  run(10, true);
  for (int i = 0; i < 100; ++i) {
    run(50, false);
    run(1, true);
  }
  EXPECT_EQ(reported_.size(), 1u);
}

TEST_F(OrientationEvents, AnIntermittentOneIsLostOnce) {
  run(10, true);
  run(60, false);
  for (int i = 0; i < 100; ++i) {
    run(1999, true);
    run(60, false);
  }
  EXPECT_EQ(reported_, (Names{"orientation_restored", "orientation_lost"}));
  run(2001, true);
  EXPECT_EQ(reported_.back(), "orientation_restored");
  EXPECT_EQ(reported_.size(), 3u);
}

TEST_F(OrientationEvents, ABusyMachinesLongTickIsNoLoss) {
  run(10, true);
  run(3, false, 400);
  run(10, true);
  EXPECT_EQ(reported_.size(), 1u);
}

}  // namespace
}  // namespace hedgehog::control
