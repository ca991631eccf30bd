// SPDX-License-Identifier: MIT
// effect.latency: from a request to the first frame with its set-point.
#include <gtest/gtest.h>

#include "daemon/device/tick_clock.h"
#include "daemon/server/effects/latency_log.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

constexpr std::int64_t kMicrosecond = 1000;

TEST(Latency, IsUnknownBeforeTheFirstEffect) {
  ServerRig rig;
  FakeClient& client = rig.connect();
  EXPECT_EQ(rig.call(client, "effect.latency"), Json::parse(R"({
    "effects": 0, "received_to_queued_us": null, "queued_to_applied_us": null,
    "applied_to_written_us": null, "received_to_written_us": null})"));
}

TEST(Latency, HasEachStageOfAnEffect) {
  ServerRig rig;
  FakeClient& client = rig.connect();
  constexpr double kWaitedUs = 5000;
  client.session.received_ns =
      device::monotonic_ns() - static_cast<std::int64_t>(kWaitedUs) * kMicrosecond;
  rig.call(client, "effect.pulse", {{"direction", "left"}, {"duration_ms", 5}});
  rig.run(3);
  client.session.received_ns = 0;
  const Json latency = rig.call(client, "effect.latency");
  EXPECT_EQ(latency["effects"], 1);
  double sum_us = 0;
  for (const char* stage :
       {"received_to_queued_us", "queued_to_applied_us", "applied_to_written_us"}) {
    EXPECT_GE(latency[stage]["p50"], 0.0) << stage;
    EXPECT_EQ(latency[stage]["p50"], latency[stage]["max"]) << stage;
    sum_us += latency[stage]["p50"].get<double>();
  }
  EXPECT_GE(latency["received_to_queued_us"]["p50"], kWaitedUs);
  EXPECT_NEAR(latency["received_to_written_us"]["p50"], sum_us, 1.0);
}

TEST(Latency, CountsUpdatesButNoOtherCommands) {
  ServerRig rig;
  FakeClient& client = rig.connect();
  rig.call(client, "effect.hold", {{"direction", "up"}, {"lease_ms", 1000}, {"slot", "a"}});
  rig.call(client, "effect.update", {{"slot", "a"}, {"level", 0.2}});
  rig.call(client, "orientation.recenter");
  rig.run(3);
  EXPECT_EQ(rig.call(client, "effect.latency")["effects"], 2);
}

TEST(Latency, QuantilesAreOfTheNewestEffects) {
  LatencyLog log;
  const auto add = [&](std::int64_t us) {
    log.add({.seq = 1,
             .received_ns = 7,
             .queued_ns = 7 + us * kMicrosecond,
             .applied_ns = 7 + us * kMicrosecond,
             .written_ns = 7 + us * kMicrosecond});
  };
  add(1'000'000);
  for (std::size_t i = 0; i < LatencyLog::kNewest; ++i) add(1 + static_cast<std::int64_t>(i) % 100);
  EXPECT_EQ(log.effects(), LatencyLog::kNewest);
  const auto queued = log.quantiles(LatencyStage::kReceivedToQueued);
  EXPECT_NEAR(queued.p50_us, 50, 2);
  EXPECT_NEAR(queued.p99_us, 99, 2);
  EXPECT_EQ(queued.max_us, 100);
  EXPECT_EQ(log.quantiles(LatencyStage::kQueuedToApplied).max_us, 0);
  // The histogram includes all of them.
  EXPECT_EQ(log.histogram(LatencyStage::kReceivedToQueued).counts.back(), 1u);
}

}  // namespace
}  // namespace hedgehog::server
