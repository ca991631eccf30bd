// SPDX-License-Identifier: MIT
// Roles of the Unix socket's users: granted by the lists, revoked by a reload.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "daemon/server/session/origin.h"
#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

constexpr int kNoRoleCode = -32003;
// Users that never run this test.
constexpr std::uint32_t kAlice = 4'000'001'001;
constexpr std::uint32_t kBob = 4'000'001'002;
const Json kLongPush{{"direction", "left"}, {"duration_ms", 5000}};

access::Principal user_principal(std::uint32_t id) {
  return {access::Principal::Kind::kUser, id, std::to_string(id)};
}

class UnixUsers : public testing::Test {
 protected:
  UnixUsers() { reload({{}, {user_principal(kAlice)}, {}}); }

  void reload(access::UnixRoles roles) {
    settings_.access.unix_roles = std::move(roles);
    settings_.access.tokens = {
        {"owner", protocol::Role::kOperate, access::digest_of("owner-secret"), ""}};
    rig_.server->set_access(settings_);
  }
  /// A client as admitted by the listener for `user`.
  FakeClient& local(std::uint32_t user) {
    FakeClient& client = rig_.connect(protocol::Role::kObserve);
    client.session.transport = "unix";
    client.session.peer = access::Peer{user, user, {}, 4711};
    rig_.server->tokens().admit(client.session);
    return client;
  }
  /// Sends requests that reach the server although the connection is ending.
  void push_late(FakeClient& client) {
    rig_.server->line(
        client.session,
        R"({"jsonrpc":"2.0","id":2,"method":"hello","params":{"token":"owner-secret"}})");
    rig_.server->line(
        client.session,
        R"({"jsonrpc":"2.0","id":1,"method":"effect.pulse","params":{"direction":"left"}})");
    rig_.run(100);
  }

  config::Config settings_;
  ServerRig rig_;
};

TEST_F(UnixUsers, HaveTheRoleOfTheirList) {
  FakeClient& alice = local(kAlice);
  EXPECT_EQ(rig_.call(alice, "hello")["role"], "play");
  EXPECT_TRUE(rig_.call(alice, "effect.pulse", kLongPush)["accepted"]);
  EXPECT_EQ(rig_.call(alice, "output.set_gain", {{"gain", 0.5}})["data"]["name"], "forbidden");
  EXPECT_EQ(rig_.call(local(0), "hello")["role"], "operate");
  EXPECT_EQ(rig_.call(local(::geteuid()), "hello")["role"], "operate");
}

TEST_F(UnixUsers, OnTheSimulatorTheListsApplyToo) {
  settings_.backend = config::Backend::kSimulator;
  reload(settings_.access.unix_roles);
  EXPECT_EQ(rig_.call(local(kBob), "hello")["code"], kNoRoleCode);
  EXPECT_EQ(rig_.call(local(kAlice), "hello")["role"], "play");
}

TEST_F(UnixUsers, WithoutARoleNothingIsExecutedAndNoCurrentFlows) {
  FakeClient& bob = local(kBob);
  for (const std::string method : {"effect.pulse", "effect.hold", "device.arm", "device.status",
                                   "device.emergency_stop", "output.set_gain"}) {
    const Json params = method.starts_with("effect.") ? Json{{"direction", "left"}}
                        : method == "output.set_gain" ? Json{{"gain", 1}}
                                                      : Json::object();
    const Json error = rig_.call(bob, method, params);
    EXPECT_EQ(error["code"], kNoRoleCode) << method;
    EXPECT_EQ(
        error["message"],
        "unauthorized: user 4000001002 has no role in access.unix of the configuration; send a "
        "token in hello first");
    rig_.run(20);
    EXPECT_LT(rig_.plant_current_a(), 0.1) << method;
  }
  EXPECT_EQ(rig_.device_view->now().state, control::State::kArmed) << "nor may it stop the ball";
  EXPECT_EQ(rig_.server->connections(), 0u) << "it takes nobody's place";
}

TEST_F(UnixUsers, WithoutARoleMaySendAToken) {
  FakeClient& bob = local(kBob);
  EXPECT_EQ(rig_.call(bob, "hello", {{"token", "owner-secret"}})["role"], "operate");
  EXPECT_TRUE(rig_.call(bob, "effect.pulse", kLongPush)["accepted"]);
}

TEST_F(UnixUsers, WithWrongTokensHaveToWaitAndOthersNot) {
  for (int i = 0; i <= FailedTokens::kFree; ++i)
    EXPECT_EQ(rig_.call(local(kBob), "hello", {{"token", "guess"}})["code"], kNoRoleCode);
  const Json waits = rig_.call(local(kBob), "hello", {{"token", "owner-secret"}});
  EXPECT_GT(waits["data"]["retry_after_ms"], 900);
  EXPECT_EQ(rig_.call(local(4'000'001'003), "hello", {{"token", "owner-secret"}})["role"],
            "operate");
}

TEST_F(UnixUsers, ThatLoseTheirRoleAtAReloadLoseTheirEffects) {
  FakeClient& alice = local(kAlice);
  FakeClient& root = local(0);
  ASSERT_TRUE(rig_.call(alice, "effect.pulse", kLongPush)["accepted"]);
  rig_.run(100);
  ASSERT_GT(rig_.plant_current_a(), 1.0);
  reload({{user_principal(kAlice)}, {}, {}});
  EXPECT_TRUE(alice.finished) << "observe is another role than play";
  EXPECT_FALSE(root.finished);
  rig_.run(100);
  EXPECT_LT(rig_.plant_current_a(), 0.1);
  push_late(alice);
  EXPECT_LT(rig_.plant_current_a(), 0.1);
  EXPECT_EQ(rig_.call(local(kAlice), "hello")["role"], "observe");
}

TEST_F(UnixUsers, WithAnUnchangedRoleStayConnected) {
  FakeClient& alice = local(kAlice);
  FakeClient& bob = local(kBob);
  FakeClient& with_token = local(kBob);
  rig_.call(with_token, "hello", {{"token", "owner-secret"}});
  reload({{}, {access::Principal{}}, {}});
  EXPECT_FALSE(alice.finished) << "everybody may play, so may she";
  EXPECT_FALSE(with_token.finished) << "its role is that of the token";
  EXPECT_TRUE(bob.finished) << "it connects again, with its role";
  EXPECT_EQ(rig_.call(local(kBob), "hello")["role"], "play");
}

TEST_F(UnixUsers, AreShownToOperators) {
  FakeClient& alice = local(kAlice);
  EXPECT_EQ(rig_.call(alice, "connection.list")["data"]["name"], "forbidden");
  rig_.connect(protocol::Role::kObserve);
  const Json list = rig_.call(local(0), "connection.list")["connections"];
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0]["uid"], kAlice);
  EXPECT_EQ(list[0]["pid"], 4711);
  EXPECT_EQ(list[0]["role"], "play");
  EXPECT_FALSE(list[1].contains("uid")) << "of TCP nothing is known";
  EXPECT_EQ(origin_text(alice.session), "unix (user 4000001001, process 4711)");
}

}  // namespace
}  // namespace hedgehog::server
