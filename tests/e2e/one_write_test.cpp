// SPDX-License-Identifier: MIT
// What comes with a tick leaves in one write for each client.
#include <gtest/gtest.h>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

TEST(OneWrite, TheEndsOfAllEffectsByAnEmergencyStop) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient game(daemon.port());
  game.call("events.subscribe", {{"types", {"effect_ended"}}});
  constexpr unsigned kEffects = 30;
  Json batch = Json::array();
  for (unsigned i = 0; i < kEffects; ++i) {
    batch.push_back({{"jsonrpc", "2.0"},
                     {"id", i},
                     {"method", "effect.hold"},
                     {"params", {{"direction", "left"}, {"current_a", 0.1}, {"lease_ms", 10000}}}});
  }
  game.send(batch.dump() + "\n");
  for (const Json& response : game.response()) ASSERT_TRUE(response.contains("result")) << response;
  const unsigned before = game.segments();
  RawClient(daemon.port()).call("device.emergency_stop");
  for (unsigned i = 0; i < kEffects; ++i)
    EXPECT_EQ(game.notification("event", "effect_ended")["reason"], "tripped");
  const unsigned segments = game.segments() - before;
  EXPECT_GE(segments, 1u);
  // The control thread may be reporting the ends while they are published.
  EXPECT_LE(segments, 3u);
  EXPECT_EQ(daemon.stop(), 0);
}

}  // namespace
}  // namespace hedgehog::e2e
