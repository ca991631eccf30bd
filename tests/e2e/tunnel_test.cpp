// SPDX-License-Identifier: MIT
// hedgehogctl tunnel: a ball behind TLS and a token, used by clients that have neither.
#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "clients/lib/ball.h"
#include "tests/e2e/tunnel_fixture.h"
#include "tests/folders.h"
#include "tests/mdns_responder.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kTokenNeeded = -32003;
const std::string kTunnelPing = R"({"jsonrpc":"2.0","id":1,"method":"ping"})"
                                "\n";

class Tunnel : public TunnelFixture {};

TEST_F(Tunnel, APulseIsPlayedWithoutASecret) {
  TunnelProcess tunnel(home_, variables(play_));
  EXPECT_EQ(ctl({"pulse", "left"}, tunnel.variables()).exit_code, 0);
  EXPECT_EQ(ctl({"gain", "0.5"}, tunnel.variables()).exit_code, 77) << "the role of its token";
  EXPECT_THAT(tunnel.program().err(), HasSubstr("with the role play"));
  RawClient game(tunnel.port());
  game.call("events.subscribe", {{"types", {"effect_ended"}}});
  const Json pulse = game.call("effect.pulse", {{"direction", "left"}});
  const Json ended = game.notification("event", "effect_ended");
  EXPECT_EQ(ended["effect"], pulse["effect"]);
  EXPECT_EQ(ended["reason"], "completed");
}

TEST_F(Tunnel, EachClientHasAConnectionOfItsOwn) {
  TunnelProcess tunnel(home_, variables(play_));
  RawClient first(tunnel.port());
  RawClient second(tunnel.port());
  const Json hello = first.call("hello", {{"client", "Racer/1.2"}});
  EXPECT_EQ(hello["role"], "play") << "a hello without a token leaves the role";
  EXPECT_NE(hello["connection"], second.call("hello")["connection"]);
  const Json connections = RawClient(daemon_->socket()).call("connection.list")["connections"];
  EXPECT_THAT(connections.dump(), HasSubstr("\"Racer/1.2\""));
  EXPECT_THAT(connections.dump(), HasSubstr("\"hedgehogctl tunnel\""));
  hold(first);
  hold(second);
  EXPECT_TRUE(eventually([&] { return status()["effects"].size() == 2; }));
  first.close();
  EXPECT_TRUE(eventually([&] { return status()["effects"].size() == 1; }));
  EXPECT_TRUE(second.call("ping").contains("time_ns"));
}

TEST_F(Tunnel, EffectsEndWithTheTunnel) {
  TunnelProcess tunnel(home_, variables(play_));
  RawClient game(tunnel.port());
  hold(game);
  tunnel.program().signal(SIGKILL);
  EXPECT_TRUE(game.closed_by_daemon());
  EXPECT_TRUE(plays_nothing());
}

TEST_F(Tunnel, AHalfClosedClientReceivesItsResponses) {
  TunnelProcess tunnel(home_, variables(play_));
  RawClient watcher(daemon_->socket());
  watcher.call("events.subscribe", {{"scope", "all"}, {"types", {"effect_ended"}}});
  RawClient once(tunnel.port());
  once.send(R"({"jsonrpc":"2.0","id":7,"method":"effect.pulse","params":)"
            R"({"direction":"left","on_close":"finish"}})"
            "\n");
  once.half_close();
  EXPECT_EQ(once.response()["result"]["accepted"], true);
  EXPECT_TRUE(once.closed_by_daemon());
  EXPECT_EQ(watcher.notification("event")["reason"], "completed");
}

TEST_F(Tunnel, AnotherFingerprintOrTokenIsRefusedWithASentence) {
  std::vector<std::string> wrong = variables(play_);
  wrong[2] = "HEDGEHOG_FINGERPRINT=" + std::string(64, '0');
  const Ended other_daemon = ctl({"tunnel", "--port", "0"}, wrong);
  EXPECT_EQ(other_daemon.exit_code, kUnavailable);
  EXPECT_EQ(other_daemon.out, "");
  EXPECT_THAT(other_daemon.err, HasSubstr("another fingerprint: " + fingerprint_));
  EXPECT_THAT(daemon_->log(), Not(HasSubstr("the token arcade"))) << "it was not sent";
  const Ended no_token = ctl({"--json", "tunnel", "--port", "0"}, variables("hht_guess"));
  EXPECT_EQ(no_token.exit_code, 77);
  EXPECT_EQ(Json::parse(no_token.err)["error"]["code"], kTokenNeeded);
}

TEST_F(Tunnel, AnotherDaemonAtTheAddressIsRejectedLater) {
  TunnelProcess tunnel(home_, variables(play_));
  const std::string address = tls_address();
  daemon_->stop(SIGKILL);
  made({"token", "certificate", "--replace"});
  start(address);
  RawClient game(tunnel.port());
  game.send(kTunnelPing);
  EXPECT_THAT(game.response()["error"]["message"].get<std::string>(),
              HasSubstr("another fingerprint"));
  EXPECT_TRUE(game.closed_by_daemon());
  EXPECT_THAT(daemon_->log(), Not(HasSubstr("the token arcade")));
}

TEST_F(Tunnel, ClientsEndWithTheDaemonAndReachTheNextOne) {
  TunnelProcess tunnel(home_, variables(play_));
  hedgehog::Ball ball(
      {client::Address{.host = "127.0.0.1", .port = static_cast<std::uint16_t>(tunnel.port())}},
      {.timeout = std::chrono::minutes(1)});
  const auto connects = [&](int times) {
    return wait_until([&] {
      ball.update();
      return ball.connected() && ball.connections() == times;
    });
  };
  ASSERT_TRUE(connects(1)) << ball.problem();
  const std::string address = tls_address();
  RawClient other(tunnel.port());
  ASSERT_EQ(other.call("hello")["role"], "play");
  daemon_->stop(SIGKILL);
  EXPECT_TRUE(other.closed_by_daemon());
  for (int i = 0; i < 2; ++i) {
    RawClient early(tunnel.port());
    early.send(kTunnelPing);
    const Json notice = early.response();
    EXPECT_EQ(notice["id"], nullptr);
    EXPECT_THAT(notice["error"]["message"].get<std::string>(),
                HasSubstr("no daemon answers at " + address + " (connection refused)"));
    EXPECT_TRUE(early.closed_by_daemon());
  }
  const std::string reported = tunnel.program().err();
  const std::string sentence = "no daemon answers at";
  EXPECT_THAT(reported, HasSubstr(sentence));
  EXPECT_EQ(reported.find(sentence), reported.rfind(sentence)) << "once, not for each client";
  start(address);
  EXPECT_TRUE(connects(2)) << ball.problem();
  EXPECT_EQ(ball.hello().role, protocol::Role::kPlay);
}

TEST_F(Tunnel, ABallThatAnnouncesItselfIsFoundByItsName) {
  const MdnsResponder responder(
      mdns_announcement("127.0.0.1", static_cast<std::uint16_t>(port("tls://"))));
  std::vector<std::string> known = variables(play_);
  known[0] = "HEDGEHOG_MDNS_PORT=" + std::to_string(responder.port());
  TunnelProcess tunnel(home_, known, {"mdns://ball-7"});
  EXPECT_EQ(ctl({"pulse", "left"}, tunnel.variables()).exit_code, 0);
  EXPECT_THAT(tunnel.program().err(), HasSubstr("mdns://ball-7"));
  const Ended unknown =
      Program(home_, hedgehogctl(), {"tunnel", "mdns://another", "--port", "0"}, known).wait();
  EXPECT_EQ(unknown.exit_code, kUnavailable);
  EXPECT_THAT(unknown.err, HasSubstr("no ball \"another\" answers on this network"));
}

TEST_F(Tunnel, AClientsOwnTokenIsUsed) {
  TunnelProcess with_token(home_, variables(play_));
  RawClient owner(with_token.port());
  EXPECT_EQ(owner.call("hello", {{"token", operate_}})["role"], "operate");
  EXPECT_EQ(owner.call("hello", {{"token", "hht_guess"}})["code"], kTokenNeeded);
  EXPECT_EQ(owner.call("hello")["role"], "operate");
  TunnelProcess without(home_, variables(""));
  // Written after the address, for which `TunnelProcess` waits.
  EXPECT_TRUE(eventually([&] {
    return without.program().err().find("HEDGEHOG_TOKEN is not set") != std::string::npos;
  })) << without.program().err();
  RawClient without_token(without.port());
  EXPECT_EQ(without_token.call("device.status")["code"], kTokenNeeded);
  EXPECT_EQ(without_token.call("hello", {{"token", play_}})["role"], "play");
}

TEST_F(Tunnel, TheCommandsOfTheDocumentRun) {
  std::ifstream document(source_folder() + "/daemon/access.md");
  const std::string begin = "    hedgehogctl tunnel tls://ball-host:7586 ";
  int commands = 0;
  for (std::string line; std::getline(document, line);) {
    if (!line.starts_with(begin)) continue;
    EXPECT_THAT(line, HasSubstr(" # ")) << "nothing but a comment follows";
    TunnelProcess tunnel(home_, variables(play_), {tls_address()});
    EXPECT_EQ(ctl({"pulse", "left"}, tunnel.variables()).exit_code, 0);
    ++commands;
  }
  EXPECT_EQ(commands, 1);
}

}  // namespace
}  // namespace hedgehog::e2e
