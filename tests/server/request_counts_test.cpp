// SPDX-License-Identifier: MIT
// The counters that are present in the metrics from the start.
#include "daemon/server/rpc/known_counters.h"

#include <gtest/gtest.h>

#include "protocol/methods.h"
#include "protocol/wire/error_set.h"

namespace hedgehog::server {
namespace {

using protocol::ErrorCode;

TEST(KnownCounters, HaveEveryErrorThatAMethodMayReturn) {
  const Counters counters = known_counters();
  for (const protocol::MethodInfo& method : protocol::kMethods) {
    EXPECT_TRUE(counters.requests.contains({method.name, 0})) << method.name;
    for (const ErrorCode code : protocol::kErrorCodes) {
      const auto series = counters.requests.find({method.name, static_cast<int>(code)});
      const bool is_there = series != counters.requests.end();
      EXPECT_EQ(is_there, protocol::possible_errors(method).contains(code))
          << method.name << " " << static_cast<int>(code);
      if (is_there) EXPECT_EQ(series->second, 0U) << method.name;
    }
  }
}

/// Each is a series that Prometheus stores for each ball.
TEST(KnownCounters, OfRequestsAreFewerThanFourHundred) {
  EXPECT_LT(known_counters().requests.size(), 400U);
}

}  // namespace
}  // namespace hedgehog::server
