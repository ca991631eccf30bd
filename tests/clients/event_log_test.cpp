// SPDX-License-Identifier: MIT
// Output of `hedgehogctl events` and its timing.
#include "clients/ctl/events/event_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hedgehog::client {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;
using testing::IsEmpty;

/// With its own clock.
class Log : public testing::Test {
 protected:
  std::vector<std::string> overrun(int second, const std::string& clock) {
    protocol::Event event{.type = "overrun", .time_ns = second * std::int64_t{1'000'000'000}};
    event.skipped = 30;
    return log_.take(event, clock, at(second));
  }
  std::vector<std::string> due(int second) { return log_.due(at(second)); }
  static EventLog::Clock::time_point at(int second) {
    return EventLog::Clock::time_point(seconds(second));
  }

  EventLog log_;
};

TEST_F(Log, ASeriesIsItsFirstEventAndThenALineAMinute) {
  EXPECT_THAT(overrun(0, "14:00:00"), ElementsAre("  14:00:00  overrun  30 ticks skipped"));
  int lines = 0;
  for (int second = 1; second <= 600; ++second) {
    EXPECT_THAT(overrun(second, "14:00:01"), IsEmpty());
    lines += static_cast<int>(due(second).size());
  }
  EXPECT_EQ(lines, 10);
}

TEST_F(Log, HeldEventsArePrintedAMinuteLaterWithoutFurtherEvents) {
  overrun(0, "14:00:00");
  overrun(1, "14:00:01");
  EXPECT_THAT(due(59), IsEmpty());
  EXPECT_THAT(due(60),
              ElementsAre("  14:00:01  overrun  60 ticks skipped, 2 times since 14:00:00"));
  EXPECT_THAT(due(600), IsEmpty());
  EXPECT_THAT(log_.rest(), IsEmpty());
}

TEST_F(Log, BeforeANewSeriesTheLastOneIsPrinted) {
  overrun(0, "14:00:00");
  overrun(1, "14:00:01");
  EXPECT_THAT(overrun(100, "14:01:40"),
              ElementsAre("  14:00:01  overrun  60 ticks skipped, 2 times since 14:00:00",
                          "  14:01:40  overrun  30 ticks skipped"));
  EXPECT_THAT(log_.rest(), IsEmpty());
}

TEST_F(Log, ARejectedMeasurementHasItsWindingAndASeriesOfItsOwn) {
  const auto rejected = [&](int second, int coil) {
    protocol::Event event{.type = "measurement_rejected",
                          .time_ns = second * std::int64_t{1'000'000'000}};
    event.disagreement = protocol::Disagreement{coil, {"heat_balance", "thermistor"}};
    return log_.take(event, "14:00:0" + std::to_string(second), at(second));
  };
  EXPECT_THAT(
      rejected(0, 1),
      ElementsAre("  14:00:00  measurement_rejected (winding y: heat_balance, thermistor)"));
  EXPECT_THAT(rejected(1, 1), IsEmpty());
  EXPECT_THAT(
      rejected(2, 2),
      ElementsAre("  14:00:02  measurement_rejected (winding z: heat_balance, thermistor)"));
  EXPECT_THAT(rejected(3, 1), IsEmpty());
  EXPECT_THAT(log_.rest(),
              ElementsAre("  14:00:03  measurement_rejected (winding y: heat_balance, thermistor), "
                          "3 times since 14:00:00"));
}

TEST_F(Log, HeldEventsArePrintedAtTheEnd) {
  overrun(0, "14:00:00");
  overrun(1, "14:00:01");
  EXPECT_THAT(log_.rest(),
              ElementsAre("  14:00:01  overrun  60 ticks skipped, 2 times since 14:00:00"));
}

TEST_F(Log, EventsThatDoNotRecurAreALineEach) {
  const protocol::Event event{.type = "derating_started", .time_ns = 7};
  for (int i = 0; i < 3; ++i)
    EXPECT_THAT(log_.take(event, "14:00:00", at(0)), ElementsAre("  14:00:00  derating_started"));
}

}  // namespace
}  // namespace hedgehog::client
