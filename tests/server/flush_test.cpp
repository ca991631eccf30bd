// SPDX-License-Identifier: MIT
// What comes with a tick, responses, events and telemetry, is written to a client together.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

constexpr int kTicks = 20;

std::string pulse(int id) {
  return R"({"jsonrpc":"2.0","method":"effect.pulse","params":{"direction":"left"},"id":)" +
         std::to_string(id) + "}";
}

TEST(Flush, EachClientThatGotLinesIsFlushedOnceATick) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  FakeClient& idle = rig.connect();
  rig.call(game, "telemetry.subscribe", {{"rate_hz", 200}, {"fields", {"state"}}});
  rig.call(game, "events.subscribe", {{"types", {"effect_started"}}});
  constexpr int kPulses = 10;
  for (int i = 0; i < kPulses; ++i) rig.server->line(game.session, pulse(i));
  idle.flushes = 0;
  std::size_t most = 0;
  for (int i = 0; i < kTicks; ++i) {
    const std::size_t lines = game.lines.size();
    const int flushes = game.flushes;
    rig.run(1);
    const std::size_t more = game.lines.size() - lines;
    EXPECT_EQ(game.flushes - flushes, more > 0 ? 1 : 0) << "tick " << i << ", lines: " << more;
    most = std::max(most, more);
  }
  EXPECT_GE(most, static_cast<std::size_t>(kPulses)) << "events of one tick";
  EXPECT_EQ(idle.flushes, 0);
}

TEST(Flush, ALineOutsideOfAPumpWaitsForNothing) {
  ServerRig rig;
  FakeClient& client = rig.connect();
  client.flushes = 0;
  rig.server->line(client.session, R"({"jsonrpc":"2.0","method":"ping","id":1})");
  EXPECT_EQ(client.flushes, 1);
}

TEST(Flush, AClientGetsAChangeOfStateBeforeItIsLogged) {
  ServerRig rig;
  FakeClient& client = rig.connect();
  rig.call(client, "events.subscribe", {{"types", {"state_changed"}}});
  int flushes_when_logged = 0;
  rig.on_listener_call = [&](const control::Event& event) {
    if (event.type == control::EventType::kStateChanged)
      flushes_when_logged = client.urgent_flushes;
  };
  client.urgent_flushes = 0;
  rig.call(client, "device.emergency_stop");
  EXPECT_EQ(flushes_when_logged, 1);
}

/// The writes to `game` in the tick in which a pulse begins; telemetry comes with each tick.
int flushes_with_the_start_of_a_pulse(ServerRig& rig, FakeClient& game) {
  rig.server->line(game.session, pulse(1));
  for (int i = 0; i < kTicks; ++i) {
    game.lines.clear();
    game.flushes = 0;
    rig.run(1);
    for (const FakeClient::Line& line : game.lines)
      if (line.kind == LineKind::kEvent) return game.flushes;
  }
  return 0;
}

TEST(Flush, NothingWaitsForAPreview) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "events.subscribe", {{"types", {"effect_started"}}});
  game.session.telemetry = {.fields = protocol::StatusKeys{1}, .period = 1};
  game.session.telemetry->next = rig.device_view->now().tick + 1;
  FakeClient& designer = rig.connect();
  rig.server->line(designer.session,
                   R"({"jsonrpc":"2.0","method":"effect.preview","params":{"method":"effect.hold",)"
                   R"("params":{"direction":"left","lease_ms":10000}},"id":1})");
  game.urgent_flushes = 0;
  EXPECT_EQ(flushes_with_the_start_of_a_pulse(rig, game), 2) << "the event, then the telemetry";
  EXPECT_GE(game.urgent_flushes, 1);
  EXPECT_TRUE(designer.lines.empty()) << "the preview goes on";
  for (int i = 0; i < 1000 && designer.lines.empty(); ++i) rig.run(1);
  ASSERT_TRUE(Json::parse(designer.lines.front().text).contains("result"));
  EXPECT_EQ(flushes_with_the_start_of_a_pulse(rig, game), 1);
}

TEST(Flush, NoMoreThanOneWriteIsKept) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.call(game, "events.subscribe", {{"types", {"effect_started"}}});
  for (int i = 0; i < 3; ++i) rig.server->line(game.session, pulse(i));
  game.lines.clear();
  game.flushes = 0;
  game.unsent_bytes = WriteQueue::kChunkBytes - 1;
  rig.run(kTicks);
  EXPECT_EQ(game.lines.size(), 3u);
  EXPECT_EQ(game.flushes, 2) << "with the first event, and at the end";
}

TEST(Flush, AClosedClientIsSkipped) {
  ServerRig rig;
  FakeClient& client = rig.connect();
  rig.server->line(client.session, R"({"jsonrpc":"2.0","method":"device.emergency_stop","id":1})");
  ASSERT_TRUE(client.lines.empty()) << "the response waits for a tick";
  rig.disconnect(client);
  rig.run(kTicks);
  EXPECT_EQ(client.lines.size(), 1u);
  EXPECT_TRUE(client.finished) << "which writes the response";
  EXPECT_EQ(client.flushes, 0);
}

}  // namespace
}  // namespace hedgehog::server
