// SPDX-License-Identifier: MIT
// Roles by token: the role given by hello, the error for a wrong token, the loss of a revoked one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

constexpr int kTokenRequired = -32003;
constexpr int kRoleTooLow = -32004;
const Json kPulse{{"direction", "left"}, {"duration_ms", 5000}};

class Tokens : public testing::Test {
 protected:
  Tokens() {
    set({{"arcade", protocol::Role::kPlay, access::digest_of("play-secret"), ""},
         {"owner", protocol::Role::kOperate, access::digest_of("operate-secret"), ""}});
  }

  void set(access::Tokens tokens) {
    settings_.backend = config::Backend::kUsb;
    settings_.access.tokens = std::move(tokens);
    rig_.server->set_access(settings_);
  }
  FakeClient& remote(const std::string& address = "192.0.2.7:5000") {
    FakeClient& client = rig_.connect(protocol::Role::kObserve);
    client.session.address = address;
    client.session.locked = true;
    return client;
  }
  Json log_in(FakeClient& client, const std::string& secret) {
    return rig_.call(client, "hello", {{"token", secret}});
  }

  config::Config settings_;
  ServerRig rig_;
};

TEST_F(Tokens, GiveAConnectionTheirRole) {
  FakeClient& client = rig_.connect(protocol::Role::kObserve);
  EXPECT_EQ(rig_.call(client, "effect.pulse", kPulse)["code"], kRoleTooLow);
  EXPECT_EQ(log_in(client, "play-secret")["role"], "play");
  EXPECT_TRUE(rig_.call(client, "effect.pulse", kPulse)["accepted"]);
  EXPECT_EQ(rig_.call(client, "output.set_gain", {{"gain", 0.5}})["code"], kRoleTooLow);
  EXPECT_EQ(log_in(client, "operate-secret")["role"], "operate");
  EXPECT_FALSE(rig_.call(client, "output.set_gain", {{"gain", 0.5}}).contains("code"));
}

TEST_F(Tokens, LimitRolesToo) {
  FakeClient& client = rig_.connect(protocol::Role::kOperate);
  client.session.transport = "unix";
  EXPECT_EQ(log_in(client, "play-secret")["role"], "play");
  EXPECT_EQ(rig_.call(client, "output.set_gain", {{"gain", 0.5}})["code"], kRoleTooLow);
  EXPECT_EQ(rig_.call(client, "hello")["role"], "play")
      << "a hello without a token changes nothing";
}

TEST_F(Tokens, AWrongOneChangesNothingAndIsNotRepeated) {
  FakeClient& client = rig_.connect(protocol::Role::kObserve);
  const Json error = log_in(client, "play-secreT");
  EXPECT_EQ(error["code"], kTokenRequired);
  EXPECT_EQ(error["data"]["field"], "token");
  EXPECT_THAT(error.dump(), testing::Not(testing::HasSubstr("secre")));
  EXPECT_EQ(rig_.call(client, "hello")["role"], "observe");
}

TEST_F(Tokens, WithoutOneALockedConnectionCannotStopTheBall) {
  FakeClient& client = remote();
  EXPECT_EQ(rig_.call(client, "device.emergency_stop")["code"], kTokenRequired);
  EXPECT_EQ(rig_.call(client, "hello")["code"], kTokenRequired);
  rig_.run(50);
  EXPECT_EQ(rig_.device_view->now().state, control::State::kArmed) << "a stranger cannot stop it";
  EXPECT_EQ(log_in(client, "play-secret")["role"], "play");
  EXPECT_FALSE(rig_.call(client, "device.emergency_stop").contains("code"));
}

TEST_F(Tokens, AfterAFewWrongOnesOnlyThatAddressHasToWait) {
  FakeClient& client = remote("192.0.2.7:5000");
  for (int i = 0; i <= FailedTokens::kFree; ++i)
    EXPECT_EQ(log_in(client, "guess")["code"], kTokenRequired);
  const Json waits = log_in(remote("192.0.2.7:5001"), "play-secret");
  EXPECT_EQ(waits["code"], kTokenRequired) << "it is not even looked at";
  EXPECT_GT(waits["data"]["retry_after_ms"], 900);
  EXPECT_EQ(log_in(remote("192.0.2.8:5000"), "play-secret")["role"], "play");
  FakeClient& local = rig_.connect(protocol::Role::kOperate);
  EXPECT_EQ(log_in(local, "play-secret")["role"], "play") << "the Unix socket has no address";
  rig_.run(FailedTokens::kFirstWait);
  EXPECT_EQ(log_in(client, "play-secret")["role"], "play");
}

TEST_F(Tokens, ARevokedOneEndsItsConnectionsAndTheirEffects) {
  FakeClient& player = remote("192.0.2.7:5000");
  FakeClient& owner = remote("192.0.2.8:5000");
  FakeClient& other = rig_.connect(protocol::Role::kOperate);
  log_in(player, "play-secret");
  log_in(owner, "operate-secret");
  ASSERT_TRUE(rig_.call(player, "effect.pulse", kPulse)["accepted"]);
  rig_.run(100);
  ASSERT_GT(rig_.plant_current_a(), 1.0);
  set({{"owner", protocol::Role::kOperate, access::digest_of("operate-secret"), ""}});
  EXPECT_TRUE(player.finished);
  EXPECT_FALSE(owner.finished);
  EXPECT_FALSE(other.finished);
  rig_.run(100);
  EXPECT_LT(rig_.plant_current_a(), 0.1);
  // Until its socket is closed it may still send requests.
  player.lines.clear();
  rig_.server->line(
      player.session,
      R"({"jsonrpc":"2.0","id":1,"method":"effect.pulse","params":{"direction":"left"}})");
  rig_.run(50);
  EXPECT_LT(rig_.plant_current_a(), 0.1);
  EXPECT_EQ(rig_.call(remote(), "hello", {{"token", "play-secret"}})["code"], kTokenRequired);
}

TEST_F(Tokens, AnotherRoleOrAnotherTokenOfTheSameNameEndsConnectionsToo) {
  FakeClient& player = remote("192.0.2.7:5000");
  FakeClient& owner = remote("192.0.2.8:5000");
  log_in(player, "play-secret");
  log_in(owner, "operate-secret");
  set({{"arcade", protocol::Role::kPlay, access::digest_of("new-secret"), ""},
       {"owner", protocol::Role::kPlay, access::digest_of("operate-secret"), ""}});
  EXPECT_TRUE(player.finished);
  EXPECT_TRUE(owner.finished);
}

TEST_F(Tokens, IfOneExistsTcpWithoutATokenMayOnlyObserve) {
  FakeClient& client = rig_.connect(protocol::Role::kPlay);
  set({});
  EXPECT_EQ(rig_.call(client, "hello")["role"], "play");
  set({{"owner", protocol::Role::kOperate, access::digest_of("operate-secret"), ""}});
  EXPECT_EQ(rig_.call(client, "hello")["role"], "observe");
  const auto role = [&](const std::string& transport) {
    Session session;
    session.transport = transport;
    return rig_.server->tokens().role_without_token(session);
  };
  EXPECT_EQ(role("websocket"), protocol::Role::kObserve);
  EXPECT_EQ(role("unix"), protocol::Role::kOperate);
  settings_.backend = config::Backend::kSimulator;
  rig_.server->set_access(settings_);
  EXPECT_EQ(rig_.call(client, "hello")["role"], "operate") << "on the simulator nobody is hurt";
}

// A WebSocket's handshake takes a round trip between its token and its session.
TEST_F(Tokens, AReloadDuringAHandshakeIsAppliedWhenTheConnectionOpens) {
  const auto admitted = [&](FakeClient& client, const char* secret) {
    client.session.transport = "websocket";
    client.session.sink = &client;
    rig_.server->tokens().admit(client.session);
    if (secret) EXPECT_FALSE(rig_.server->log_in(client.session, secret));
  };
  set({});
  FakeClient without(*rig_.server);
  admitted(without, nullptr);
  ASSERT_EQ(without.session.role, protocol::Role::kPlay);
  const access::Token owner{"owner", protocol::Role::kOperate, access::digest_of("owner-secret"),
                            ""};
  set({{"arcade", protocol::Role::kPlay, access::digest_of("play-secret"), ""}, owner});
  FakeClient revoked(*rig_.server);
  FakeClient kept(*rig_.server);
  admitted(revoked, "play-secret");
  admitted(kept, "owner-secret");
  set({owner});
  for (FakeClient* client : {&without, &revoked, &kept}) rig_.server->open(client->session);
  EXPECT_EQ(without.session.role, protocol::Role::kObserve);
  EXPECT_FALSE(without.finished);
  EXPECT_TRUE(revoked.finished);
  rig_.server->line(
      revoked.session,
      R"({"jsonrpc":"2.0","id":1,"method":"effect.pulse","params":{"direction":"left"}})");
  rig_.run(100);
  EXPECT_LT(rig_.plant_current_a(), 0.1);
  EXPECT_FALSE(kept.finished);
  EXPECT_EQ(kept.session.role, protocol::Role::kOperate);
}

TEST_F(Tokens, LockedConnectionsTakeNoPlaceBeforeTheirToken) {
  settings_.connections.max = 2;
  rig_.server->set_access(settings_);
  rig_.connect(protocol::Role::kObserve);
  FakeClient& first = remote("192.0.2.7:1");
  FakeClient& second = remote("192.0.2.7:2");
  EXPECT_EQ(rig_.server->connections(), 1u);
  EXPECT_EQ(log_in(first, "play-secret")["role"], "play");
  EXPECT_EQ(rig_.server->connections(), 2u);
  EXPECT_EQ(log_in(second, "play-secret")["code"], -32001) << "busy";
  EXPECT_EQ(rig_.call(second, "ping")["code"], kTokenRequired);
  rig_.disconnect(first);
  EXPECT_EQ(log_in(second, "play-secret")["role"], "play");
}

}  // namespace
}  // namespace hedgehog::server
