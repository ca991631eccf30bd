// SPDX-License-Identifier: MIT
// Criteria for a successful tour.
#include "clients/ctl/demo/tour_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hedgehog::client {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::int64_t kBeganNs = 5'000'000'000;

protocol::Status at_the_end(double min_limit_a, std::optional<std::int64_t> tripped_ns) {
  protocol::Status status;
  status.simulated = true;
  status.limit_a = min_limit_a;
  if (tripped_ns)
    status.last_trip = protocol::TripStatus{.reason = "sensor_open", .time_ns = *tripped_ns};
  return status;
}

std::vector<std::string> failures(const protocol::Status& last, bool starts_warm) {
  TourRecord record;
  record.take(last);
  return record.failures(last, kBeganNs, starts_warm);
}

TEST(TourRecord, OnlyItsOwnWarmBallHasToBeDerated) {
  EXPECT_THAT(failures(at_the_end(15.0, {}), false), IsEmpty());
  EXPECT_THAT(failures(at_the_end(8.7, {}), true), IsEmpty());
  EXPECT_THAT(failures(at_the_end(15.0, {}), true),
              ElementsAre("the long push was never derated: 15.0 A at least"));
}

TEST(TourRecord, ATripBeforeTheTourDoesNotCount) {
  EXPECT_THAT(failures(at_the_end(15.0, kBeganNs - 1), false), IsEmpty());
  EXPECT_THAT(failures(at_the_end(15.0, kBeganNs), false), ElementsAre("tripped: sensor_open"));
}

TEST(TourRecord, CurrentAfterTheEndIsAFailure) {
  protocol::Status last = at_the_end(15.0, {});
  last.current_a = {0, 0.5, 0};
  EXPECT_THAT(failures(last, false), ElementsAre("0.50 A flow after the end"));
}

TEST(TourRecord, TheCurrentOfAPushIsNotThatOfOneNoisySample) {
  TourRecord record;
  EXPECT_EQ(record.take_current_a(), std::nullopt);
  for (const double current_a : {0.1, 4.0, 9.9, 10.2, 9.9, 10.0, 3.0}) {
    protocol::Status status;
    status.current_a = {0, current_a, 0};
    record.take(status);
  }
  EXPECT_THAT(record.take_current_a(), testing::Optional(testing::DoubleNear(10.0, 1e-9)));
  EXPECT_EQ(record.take_current_a(), std::nullopt) << "taken";
}

}  // namespace
}  // namespace hedgehog::client
