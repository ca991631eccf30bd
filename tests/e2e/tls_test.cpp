// SPDX-License-Identifier: MIT
// The daemon used from another machine: TLS, tokens, and what unauthenticated clients can do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "clients/lib/ball.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/timeout.h"
#include "tests/e2e/tls_fixture.h"
#include "tests/e2e/tls_tunnel.h"
#include "tests/e2e/web_client.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kUnauthorized = -32003;

class Tls : public TlsFixture {
 protected:
  const std::vector<std::string> words_{"--listen", "tls://127.0.0.1:0"};
  const DaemonProcess daemon_{home_, words_};
  const TlsTunnel tunnel_{port("tls://")};
  const TlsTunnel web_{port("https://")};

  /// Output of openssl's own client.
  std::string s_client(const std::string& options, const std::string& input = "") {
    const std::string command = "printf '" + input + "' | openssl s_client -connect 127.0.0.1:" +
                                std::to_string(port("tls://")) + " " + options + " 2>&1";
    return Program(home_, "/bin/sh", {"-c", command}).wait().out;
  }
};

TEST_F(Tls, APinnedFingerprintAndATokenGiveTheirRole) {
  EXPECT_EQ(ctl({"pulse", "left"}, variables(play_)).exit_code, 0);
  EXPECT_EQ(ctl({"gain", "0.5"}, variables(play_)).exit_code, 77) << "needs operate";
  EXPECT_EQ(ctl({"gain", "0.5"}, variables(operate_)).exit_code, 0);
}

TEST_F(Tls, AnotherFingerprintOrAnUnknownAuthorityIsRejected) {
  std::vector<std::string> wrong = variables(play_);
  wrong[2] = "HEDGEHOG_FINGERPRINT=" + std::string(64, '0');
  const Ended pinned = ctl({"status"}, wrong);
  EXPECT_EQ(pinned.exit_code, 69);
  EXPECT_THAT(pinned.err, HasSubstr("another fingerprint: " + fingerprint_));
  wrong[2] = "HEDGEHOG_FINGERPRINT=";
  EXPECT_EQ(ctl({"status"}, wrong).exit_code, 69) << "nobody vouches for a self-signed certificate";
  EXPECT_THAT(daemon_.log(), Not(HasSubstr("the token arcade"))) << "it was not sent";
}

TEST_F(Tls, AFrameLoopOfTheClientLibraryConnectsToo) {
  client::Address address{.host = "127.0.0.1",
                          .port = static_cast<std::uint16_t>(port("tls://")),
                          .tls = true,
                          .fingerprint = base::parse_sha256(fingerprint_),
                          .token = play_};
  hedgehog::Ball ball({address}, {.timeout = std::chrono::minutes(1)});
  ASSERT_TRUE(wait_until([&] {
    ball.update();
    return ball.connected();
  })) << ball.problem();
  EXPECT_EQ(ball.hello().role, protocol::Role::kPlay);
  EXPECT_TRUE(ball.pulse(protocol::Word::kLeft).has_value());
}

TEST_F(Tls, WithoutATokenNothingIsExecuted) {
  RawClient without_token(tunnel_.port());
  EXPECT_EQ(without_token.call("device.status")["code"], kUnauthorized);
  EXPECT_EQ(without_token.call("device.emergency_stop")["code"], kUnauthorized);
  EXPECT_EQ(without_token.call("hello", {{"token", "hht_guess"}})["code"], kUnauthorized);
  EXPECT_EQ(without_token.call("hello", {{"token", play_}})["role"], "play");
  EXPECT_EQ(without_token.call("device.status")["state"], "armed");
}

TEST_F(Tls, OnlyVersion13WithoutEarlyDataTicketsOrRenegotiation) {
  for (const std::string old : {"-tls1_2", "-tls1_1 -cipher DEFAULT@SECLEVEL=0"})
    EXPECT_THAT(s_client(old), HasSubstr("Cipher is (NONE)")) << old;
  const std::string now = s_client("");
  EXPECT_THAT(now, HasSubstr("New, TLSv1.3"));
  EXPECT_THAT(now, HasSubstr("Early data was not sent"));
  const std::string session = home_.path("session.pem");
  const std::string session_output = s_client("-ign_eof -sess_out " + session, "x\\n");
  EXPECT_THAT(session_output, HasSubstr("New, TLSv1.3")) << "the daemon closes at the x";
  EXPECT_THAT(session_output, Not(HasSubstr("Post-Handshake New Session Ticket")));
  EXPECT_EQ(home_.read("session.pem"), "") << "a session that could be resumed";
  EXPECT_THAT(s_client("", "R\\n"), HasSubstr("wrong ssl version")) << "TLS 1.3 has none";
}

TEST_F(Tls, WebSocketTakesTheTokenInTheHeaderOrInHello) {
  WebSocketClient with_header(web_.port(), "Authorization: Bearer " + play_ + "\r\n");
  EXPECT_EQ(with_header.response().status, 101);
  EXPECT_EQ(with_header.call("hello")["role"], "play");
  WebSocketClient later(web_.port());
  EXPECT_EQ(later.response().status, 101);
  EXPECT_EQ(later.call("device.status")["code"], kUnauthorized);
  EXPECT_EQ(later.call("hello", {{"token", operate_}})["role"], "operate");
  const WebSocketClient wrong(web_.port(), "Authorization: Bearer hht_guess\r\n");
  EXPECT_EQ(wrong.response().status, 401);
  const WebSocketClient foreign(web_.port(), "Origin: https://evil.example\r\n");
  EXPECT_EQ(foreign.response().status, 403);
}

TEST_F(Tls, HttpWithoutATokenServesNothingOfTheBall) {
  for (const std::string path : {"/metrics", "/healthz", "/recordings/trip-0001.hhr"}) {
    const WebResponse response = web_get(web_.port(), path, "Host: ball-host\r\n");
    EXPECT_EQ(response.status, 401) << path;
    EXPECT_THAT(response.header("www-authenticate"), HasSubstr("Bearer")) << path;
  }
  const std::string bearer = "Host: ball-host\r\nAuthorization: Bearer " + play_ + "\r\n";
  EXPECT_THAT(web_get(web_.port(), "/metrics", bearer).body,
              HasSubstr("hedgehog_connections_rejected_total"));
  EXPECT_EQ(web_get(web_.port(), "/healthz", bearer).status, 200);
  EXPECT_EQ(web_get(web_.port(), "/recordings/trip-0001.hhr", bearer).status, 404);
}

TEST_F(Tls, HttpIsServedWhileAllClientsAreConnected) {
  home_.configure(R"({"http": {"listen": "tls://127.0.0.1:0"}, "connections": {"max": 1}})");
  daemon_.signal(SIGHUP);
  ASSERT_TRUE(daemon_.logs("configuration reloaded"));
  RawClient player(tunnel_.port());
  ASSERT_EQ(player.call("hello", {{"token", play_}})["role"], "play");
  RawClient another(tunnel_.port());
  ASSERT_EQ(another.call("hello", {{"token", play_}})["code"], -32001) << "one is connected";
  const std::string bearer = "Host: ball-host\r\nAuthorization: Bearer " + play_ + "\r\n";
  EXPECT_EQ(web_get(web_.port(), "/healthz", bearer).status, 200);
  EXPECT_THAT(web_get(web_.port(), "/metrics", bearer).body,
              HasSubstr("hedgehog_connections_rejected_total{device=\"ball\",reason=\"cap\"} 1\n"));
}

TEST_F(Tls, HttpConnectionsAreBoundedAlsoWithAToken) {
  constexpr int kMax = 64;
  const std::string request =
      "GET /healthz HTTP/1.1\r\nHost: ball-host\r\nAuthorization: Bearer " + play_ + "\r\n\r\n";
  const auto status_of = [&](RawClient& client) {
    client.send(request);
    return client.bytes(12).value_or("");
  };
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < kMax; ++i) {
    clients.push_back(std::make_unique<RawClient>(web_.port()));
    ASSERT_EQ(status_of(*clients.back()), "HTTP/1.1 200") << i;
  }
  const auto another = [&] {
    RawClient client(web_.port());
    return status_of(client);
  };
  EXPECT_EQ(another(), "HTTP/1.1 503");
  clients.pop_back();
  EXPECT_TRUE(eventually([&] { return another() == "HTTP/1.1 200"; }));
}

TEST_F(Tls, SlowAndInvalidHandshakesBlockNoOtherClient) {
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < 60; ++i) {
    clients.push_back(std::make_unique<RawClient>(port(i % 2 == 0 ? "tls://" : "https://")));
    if (i % 3 == 1) clients.back()->send("GET / HTTP/1.1\r\n\r\n");
    if (i % 3 == 2) clients.back()->send("\x16\x03\x01\x02");  // begins a handshake
  }
  EXPECT_EQ(ctl({"pulse", "left"}, variables(play_)).exit_code, 0);
  EXPECT_TRUE(clients.front()->closed_by_daemon()) << "the oldest lost its place";
  EXPECT_EQ(ctl({"stop"}, variables(play_)).exit_code, 0) << "the emergency stop by TLS";
  RawClient local(daemon_.socket());
  EXPECT_EQ(local.call("device.status")["state"], "disarmed");
}

TEST_F(Tls, AnAuthenticatedClientStaysConnectedAmongManyOthers) {
  RawClient player(tunnel_.port());
  ASSERT_EQ(player.call("hello", {{"token", play_}})["role"], "play");
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < 20; ++i) {
    clients.push_back(std::make_unique<RawClient>(tunnel_.port()));
    // Completes the handshake; the daemon may have closed a connection above its limit.
    clients.back()->send("{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"ping\"}\n");
    clients.back()->line();
  }
  EXPECT_TRUE(clients.front()->closed_by_daemon());
  EXPECT_TRUE(player.call("ping").contains("time_ns"));
}

TEST_F(Tls, ARevokedTokenEndsItsConnectionsAtTheReload) {
  RawClient player(tunnel_.port());
  RawClient owner(tunnel_.port());
  ASSERT_EQ(player.call("hello", {{"token", play_}})["role"], "play");
  ASSERT_EQ(owner.call("hello", {{"token", operate_}})["role"], "operate");
  EXPECT_EQ(ctl({"token", "revoke", "arcade"}, {}).exit_code, 0);
  daemon_.signal(SIGHUP);
  EXPECT_TRUE(player.closed_by_daemon());
  EXPECT_TRUE(owner.call("ping").contains("time_ns"));
  EXPECT_EQ(ctl({"status"}, variables(play_)).exit_code, 77);
}

TEST_F(Tls, ANewCertificateIsUsedAfterAReload) {
  const std::string fresh = made({"token", "certificate", "--replace"});
  EXPECT_NE(fresh, fingerprint_);
  EXPECT_EQ(ctl({"status"}, variables(play_)).exit_code, 0) << "not before";
  daemon_.signal(SIGHUP);
  ASSERT_TRUE(daemon_.logs("configuration reloaded"));
  fingerprint_ = fresh;
  EXPECT_EQ(ctl({"status"}, variables(play_)).exit_code, 0);
}

TEST_F(Tls, NothingSecretIsInTheLogOrTheConfiguration) {
  ctl({"status"}, variables(play_));
  ctl({"status"}, variables("hht_wrong-secret"));
  daemon_.signal(SIGHUP);
  ASSERT_TRUE(daemon_.logs("configuration reloaded"));
  const std::string shown = daemon_.log() + run_daemon(home_, {"--print-config"}).out;
  const std::string tokens = home_.read("state/hedgehog/tokens");
  const std::string digest = tokens.substr(tokens.find("sha256:") + 7, 64);
  const std::string key = home_.read("state/hedgehog/key.pem");
  EXPECT_THAT(shown, HasSubstr("state/hedgehog/tokens")) << "places are no secret";
  EXPECT_THAT(shown, HasSubstr("the token arcade gives"));
  for (const std::string& secret :
       {play_, operate_, std::string("hht_wrong-secret"), digest, key.substr(30, 40)})
    EXPECT_THAT(shown, Not(HasSubstr(secret)));
}

TEST(Access, OffLoopbackTheDaemonNeedsTokensAndACertificate) {
  const Home home;
  const auto check = [&] { return run_daemon(home, {"--listen", "0.0.0.0:0", "--check-config"}); };
  const auto token = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "token");
    words.insert(words.end(), {"--state", home.path("state/hedgehog")});
    return Program(home, hedgehogctl(), words).wait();
  };
  EXPECT_EQ(check().exit_code, 78);
  EXPECT_THAT(check().err, HasSubstr("hedgehogctl token add NAME"));
  EXPECT_EQ(token({"add", "arcade"}).exit_code, 0);
  EXPECT_EQ(check().exit_code, 78);
  EXPECT_THAT(check().err, HasSubstr("hedgehogctl token certificate"));
  const std::string first = token({"certificate"}).out;
  EXPECT_EQ(token({"certificate"}).out, first) << "the same one again";
  EXPECT_EQ(check().exit_code, 0) << check().err;
  EXPECT_EQ(token({"revoke", "arcade"}).exit_code, 0);
  EXPECT_EQ(check().exit_code, 0) << "whoever revokes the last token keeps everybody out";
  home.write("state/hedgehog/tokens", "arcade play\n");
  EXPECT_EQ(check().exit_code, 78);
  EXPECT_THAT(check().err, HasSubstr("state/hedgehog/tokens:1: "));
}

TEST(Access, TokensAreListedWithoutTheirSecrets) {
  const Home home;
  const auto token = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "token");
    words.insert(words.end(), {"--state", home.path("state/hedgehog")});
    return Program(home, hedgehogctl(), words).wait();
  };
  const std::string secret = token({"add", "lab.1", "--role", "observe"}).out;
  EXPECT_EQ(token({"add", "lab.1"}).exit_code, 64) << "the name is taken";
  EXPECT_EQ(token({"add", "two words"}).exit_code, 64);
  EXPECT_EQ(token({"add", "x", "--role", "master"}).exit_code, 64);
  const std::string listed = token({"list"}).out + token({"list", "--json"}).out;
  EXPECT_THAT(listed, HasSubstr("lab.1"));
  EXPECT_THAT(listed, HasSubstr("\"role\":\"observe\""));
  EXPECT_THAT(listed, Not(HasSubstr(secret.substr(4, 20))));
  EXPECT_EQ(token({"revoke", "nobody"}).exit_code, 66);
}

}  // namespace
}  // namespace hedgehog::e2e
