// SPDX-License-Identifier: MIT
// Requests that are held until their client reads its responses, and requests after them.
#include <gtest/gtest.h>

#include <string>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

std::string request(int id, const std::string& method, const Json& params = Json::object()) {
  return Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}}.dump();
}

TEST(Held, RequestsBeforeAStopStartNothingAfterIt) {
  ServerRig rig;
  FakeClient& client = rig.connect();
  rig.call(client, "device.emergency_stop");
  client.session.bypassed = 1;
  const Json left{{"direction", "left"}};
  for (const char* start : {"effect.pulse", "effect.circle", "effect.vibrate", "effect.hold"}) {
    const Json params = std::string(start) == "effect.circle" ? Json::object() : left;
    EXPECT_EQ(rig.call(client, start, params)["code"], -32001) << start;
  }
  EXPECT_EQ(rig.call(client, "effect.update", {{"slot", "x"}})["code"], -32001);
  EXPECT_EQ(rig.call(client, "device.claim")["code"], -32001);
  const Json arm = rig.call(client, "device.arm");
  EXPECT_EQ(arm["code"], -32001);
  EXPECT_EQ(arm["message"],
            "busy: superseded by a later emergency stop, or by the end of the connection");
  EXPECT_EQ(rig.call(client, "device.status")["state"], "disarmed");
  EXPECT_EQ(rig.call(client, "device.emergency_stop")["state"], "disarmed");
  client.session.bypassed = 0;
  EXPECT_EQ(rig.call(client, "device.arm")["state"], "armed");
}

TEST(Held, AHalfCloseEndsTheEffectsAtOnceAndHeldResponsesAreSent) {
  ServerRig rig;
  FakeClient& watcher = rig.connect();
  rig.call(watcher, "events.subscribe", {{"scope", "all"}, {"types", {"effect_ended"}}});
  FakeClient& client = rig.connect();
  rig.call(client, "effect.hold", {{"direction", "left"}, {"lease_ms", 9000}});
  rig.call(client, "device.claim");
  client.session.held = client.session.bypassed = 1;
  rig.server->close(client.session);
  rig.run(3);
  const auto ended = rig.on_event(watcher);
  ASSERT_EQ(ended.size(), 1u);
  EXPECT_EQ(ended[0]["reason"], "disconnected");
  EXPECT_TRUE(rig.call(watcher, "effect.pulse", {{"direction", "left"}}).contains("effect"))
      << "nobody has claimed it";
  EXPECT_FALSE(client.finished);
  EXPECT_TRUE(rig.call(client, "ping").contains("time_ns"));
  EXPECT_EQ(rig.call(client, "device.claim")["code"], -32001);
  client.session.held = client.session.bypassed = 0;
  rig.server->close(client.session);
  EXPECT_TRUE(client.finished);
}

TEST(Held, ResponsesThatWaitForTheirBatchCount) {
  ServerRig rig;
  rig.state_store.persisted = Persisted::kPending;
  FakeClient& client = rig.connect();
  std::string batch = "[";
  for (int i = 0; i < 30; ++i) batch += request(i, "device.describe") + ",";
  rig.server->line(client.session, batch + request(30, "device.emergency_stop") + "]");
  EXPECT_TRUE(client.lines.empty());
  const std::size_t open = client.session.open_bytes;
  EXPECT_GT(open, 100'000u);
  rig.server->line(client.session, request(31, "device.emergency_stop"));
  EXPECT_EQ(client.session.open_bytes, open + Dispatcher::kReservedBytes);
  rig.state_store.persisted = Persisted::kYes;
  rig.run(5);
  ASSERT_EQ(client.lines.size(), 2u);
  EXPECT_EQ(Json::parse(client.lines[0].text).size(), 31u);
  EXPECT_NEAR(static_cast<double>(client.lines[0].text.size()), static_cast<double>(open), 2000);
  EXPECT_EQ(client.session.open_bytes, 0u);
}

TEST(Held, PendingResponsesCountAgainstTheLimitOfABatch) {
  ServerRig rig;
  rig.state_store.persisted = Persisted::kPending;
  FakeClient& client = rig.connect();
  client.session.batch_bytes = 4 * Dispatcher::kReservedBytes;
  std::string batch = "[";
  for (int i = 0; i < 5; ++i) batch += request(i, "device.emergency_stop") + ",";
  rig.server->line(client.session, batch + request(5, "ping") + "]");
  rig.state_store.persisted = Persisted::kYes;
  rig.run(5);
  ASSERT_EQ(client.lines.size(), 1u);
  const Json responses = Json::parse(client.lines[0].text);
  EXPECT_TRUE(responses[4].contains("result")) << "a stop is carried out whatever waits";
  EXPECT_EQ(responses[5]["error"]["code"], -32001);
}

TEST(Held, AnEmergencyStopIsFoundAtAnyPositionOfALine) {
  EXPECT_TRUE(Server::has_emergency_stop(request(1, "device.emergency_stop")));
  EXPECT_TRUE(Server::has_emergency_stop("[" + request(1, "ping") + "," +
                                         request(2, "device.emergency_stop") + "]"));
  EXPECT_TRUE(
      Server::has_emergency_stop(R"({"jsonrpc":"2.0","method":"device.emergency\u005fstop"})"));
  EXPECT_FALSE(Server::has_emergency_stop(request(1, "effect.stop_all")));
  EXPECT_FALSE(
      Server::has_emergency_stop(request(1, "hello", {{"client", "device.emergency_stop"}})));
  EXPECT_FALSE(Server::has_emergency_stop("device.emergency_stop"));
}

}  // namespace
}  // namespace hedgehog::server
