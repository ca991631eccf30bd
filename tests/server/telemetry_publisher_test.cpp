// SPDX-License-Identifier: MIT
// Telemetry to many clients: encoded once per distinct subscription, sent in slices, in turn.
#include <gtest/gtest.h>

#include <vector>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

constexpr std::size_t kCrowd = TelemetryPublisher::kSlice + 36;

/// More often than a request may; the server notices it at the next line.
void subscribe(const ServerRig& rig, FakeClient& client, model::Tick period,
               protocol::StatusKeys fields = protocol::StatusKeys{0b11}) {
  client.session.telemetry = {.fields = fields, .period = period};
  client.session.telemetry->next = rig.device_view->now().tick;
  rig.server->line(client.session, R"({"jsonrpc":"2.0","method":"ping"})");
}

std::vector<FakeClient*> crowd(ServerRig& rig, model::Tick period) {
  std::vector<FakeClient*> clients;
  for (std::size_t i = 0; i < kCrowd; ++i) {
    clients.push_back(&rig.connect());
    subscribe(rig, *clients.back(), period);
  }
  return clients;
}

std::size_t lines(const std::vector<FakeClient*>& clients) {
  std::size_t count = 0;
  for (const FakeClient* client : clients) count += client->lines.size();
  return count;
}

TEST(TelemetryPublisher, SendsASliceAndLeavesTheRestForTheNextPumps) {
  ServerRig rig;
  const auto clients = crowd(rig, 100);
  rig.run(1);
  EXPECT_EQ(lines(clients), TelemetryPublisher::kSlice);
  EXPECT_TRUE(rig.server->has_unsent_telemetry());
  rig.server->pump();
  EXPECT_FALSE(rig.server->has_unsent_telemetry());
  for (const FakeClient* client : clients) {
    ASSERT_EQ(client->lines.size(), 1u);
    EXPECT_EQ(client->lines.front().text, clients.front()->lines.front().text);
    EXPECT_EQ(client->lines.front().kind, LineKind::kTelemetry);
  }
}

TEST(TelemetryPublisher, UnderOverloadSubscribersAreServedInTurn) {
  static_assert(kCrowd <= 2 * TelemetryPublisher::kSlice);
  ServerRig rig;
  const auto clients = crowd(rig, 1);
  constexpr std::size_t kPumps = 100;
  rig.run(static_cast<model::Tick>(kPumps));
  EXPECT_EQ(lines(clients), kPumps * TelemetryPublisher::kSlice);
  for (const FakeClient* client : clients) EXPECT_GE(client->lines.size(), kPumps / 2);
}

TEST(TelemetryPublisher, EachSetOfFieldsIsOneLine) {
  ServerRig rig;
  FakeClient& one = rig.connect();
  FakeClient& other = rig.connect();
  subscribe(rig, one, 10);
  subscribe(rig, other, 10, protocol::StatusKeys{0b1});
  rig.run(1);
  const Json first = Json::parse(one.lines.front().text)["params"];
  const Json second = Json::parse(other.lines.front().text)["params"];
  EXPECT_TRUE(first.contains("simulated"));
  EXPECT_FALSE(second.contains("simulated"));
  EXPECT_EQ(first["time_ns"], second["time_ns"]);
}

TEST(TelemetryPublisher, AWaitingSubscriberThatUnsubscribesOrClosesGetsNoMore) {
  ServerRig rig;
  const auto clients = crowd(rig, 100);
  rig.run(1);
  clients.back()->session.telemetry.reset();
  rig.disconnect(*clients[kCrowd - 2]);
  rig.server->pump();
  EXPECT_TRUE(clients.back()->lines.empty());
  EXPECT_TRUE(clients[kCrowd - 2]->lines.empty());
  EXPECT_EQ(lines(clients), kCrowd - 2);
}

TEST(TelemetryPublisher, AWaitingSubscriberThatResubscribesIsServedOnce) {
  ServerRig rig;
  const auto clients = crowd(rig, 100);
  rig.run(1);
  subscribe(rig, *clients.back(), 100);
  rig.server->pump();
  rig.run(99);
  EXPECT_EQ(clients.back()->lines.size(), 1u);
  rig.run(1);
  EXPECT_EQ(clients.back()->lines.size(), 2u);
}

}  // namespace
}  // namespace hedgehog::server
