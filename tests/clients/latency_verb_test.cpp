// SPDX-License-Identifier: MIT
// Output of `hedgehogctl latency`.
#include "clients/ctl/verbs/latency_verb.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hedgehog::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(LatencyVerb, HasALineForEachStage) {
  protocol::LatencyResult latency;
  latency.effects = 250;
  latency.received_to_queued_us = {10.4, 31.0, 1250.0};
  latency.queued_to_applied_us = {500, 990, 1010};
  latency.applied_to_written_us = {120, 180, 12'000};
  latency.received_to_written_us = {640, 1200, 13'500};
  EXPECT_THAT(latency_lines(latency),
              ElementsAre("The newest 250 effects, milliseconds:",
                          "                               p50       p99       max",
                          "read to queued               0.010     0.031     1.250",
                          "queued to applied            0.500     0.990     1.010",
                          "applied to frame sent        0.120     0.180    12.000",
                          "read to frame sent           0.640     1.200    13.500"));
}

TEST(LatencyVerb, WithoutEffectsItExplainsHowToPlayOne) {
  EXPECT_THAT(latency_lines({}), ElementsAre(HasSubstr("hedgehogctl pulse")));
}

}  // namespace
}  // namespace hedgehog::client
