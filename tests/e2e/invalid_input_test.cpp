// SPDX-License-Identifier: MIT
// Any bytes on a socket get their documented response, and other clients are not affected.
#include <gtest/gtest.h>

#include <string>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

/// A request of exactly `bytes` bytes.
std::string padded_ping(std::size_t bytes) {
  const std::string head = R"({"jsonrpc":"2.0","id":1,"method":"ping"})";
  return head + std::string(bytes - head.size(), ' ');
}

struct ShortTimeoutHome : Home {
  ShortTimeoutHome() { configure(R"({"connections": {"write_timeout_s": 1}})"); }
};

/// One daemon for all tests; beside each client that sends garbage a game keeps playing.
class InvalidInput : public testing::Test {
 protected:
  void SetUp() override {
    game_.call("events.subscribe", {{"types", {"effect_started", "effect_ended"}}});
    effect_ = game_.call("effect.hold", {{"direction", "up"}, {"lease_ms", 10000}})["effect"];
  }
  void TearDown() override {
    play_on();
    EXPECT_EQ(game_.notification("event", "effect_started")["type"], "effect_started");
    EXPECT_EQ(game_.call("effect.stop", {{"effect", effect_}})["stopped"], 1);
    const Json ended = game_.notification("event");
    EXPECT_EQ(ended["type"], "effect_ended");
    EXPECT_EQ(ended["reason"], "stopped");
  }

  /// Renews the game's lease and checks that the game lost nothing: its effect still plays, and its
  /// next response is the right one.
  void play_on() {
    const Json renewed = game_.call("effect.update", {{"effect", effect_}});
    EXPECT_EQ(renewed["effect"], effect_) << renewed;
  }
  int code(std::string_view line) {
    play_on();
    EXPECT_TRUE(client_.send(line));
    EXPECT_TRUE(client_.send("\n"));
    const Json response = client_.response();
    return response.contains("error") ? response["error"]["code"].get<int>() : 0;
  }
  void expect_alive() { EXPECT_TRUE(client_.call("ping").contains("time_ns")); }

  ShortTimeoutHome home_;
  DaemonProcess daemon_{home_};
  RawClient game_{daemon_.port()};
  RawClient client_{daemon_.port()};
  Json effect_;
};

TEST_F(InvalidInput, ALineOf64KiBIsServedAndALongerOneIsNot) {
  EXPECT_EQ(code(padded_ping(kMaxLine)), 0);
  EXPECT_EQ(code(padded_ping(kMaxLine) + "\r"), 0);
  EXPECT_EQ(code(padded_ping(kMaxLine + 1)), -32700);
  expect_alive();
}

TEST_F(InvalidInput, AMegabyteWithoutALineEndIsOneError) {
  EXPECT_TRUE(client_.send("{" + std::string(1 << 20, 'x')));
  EXPECT_EQ(client_.response()["error"]["code"], -32700);
  EXPECT_TRUE(client_.send("\n"));
  expect_alive();
}

TEST_F(InvalidInput, HalfALineIsDiscardedWithItsConnection) {
  EXPECT_TRUE(client_.send(R"({"jsonrpc":"2.0","id":1,"method":"pi)"));
  client_.half_close();
  EXPECT_TRUE(client_.closed_by_daemon());
}

TEST_F(InvalidInput, InvalidJsonIsAParseError) {
  EXPECT_EQ(code("{"), -32700);
  EXPECT_EQ(code(""), -32700);
  EXPECT_EQ(code("{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"\xff\xfe\"}"), -32700);
  EXPECT_EQ(code(std::string(30'000, '[')), -32700);
  EXPECT_EQ(code(std::string(30'000, '[') + std::string(30'000, ']')), -32700);
  EXPECT_EQ(code(R"({"jsonrpc":"2.0","id":1,"method":"ping","x":1e999})"), -32700);
  EXPECT_EQ(code("hello"), -32700);  // no longer the first line
  EXPECT_EQ(code(R"({"jsonrpc":"2.0","id":7,"method":"ping"})" + std::string(1, '\0') + " garbage"),
            -32700)
      << "a NUL ends no line";
  expect_alive();
}

TEST_F(InvalidInput, JsonThatIsNoRequestIsInvalid) {
  EXPECT_EQ(code("{}"), -32600);
  EXPECT_EQ(code("[]"), -32600);
  EXPECT_EQ(code("[" +
                 [] {
                   std::string items = "1";
                   for (int i = 0; i < 64; ++i) items += ",1";
                   return items;
                 }() +
                 "]"),
            -32600);
  EXPECT_EQ(code(R"({"jsonrpc":"2.0","id":1,"method":"no.such"})"), -32601);
  EXPECT_EQ(code(R"({"jsonrpc":"2.0","id":1,"method":"effect.pulse","params":{"direction":7}})"),
            -32602);
  EXPECT_EQ(code(R"({"jsonrpc":"2.0","id":1,"method":"effect.pulse",)"
                 R"("params":{"direction":"up","duration_ms":1e300}})"),
            -32602);
  EXPECT_EQ(code(R"({"jsonrpc":"2.0","id":1,"method":"effect.pulse","params":["up"]})"), -32602);
  expect_alive();
}

TEST_F(InvalidInput, AMixedBatchIsAnsweredInOrder) {
  EXPECT_TRUE(client_.send(
      R"([{"jsonrpc":"2.0","id":1,"method":"ping"},7,{"jsonrpc":"2.0","method":"no.such"},)"
      R"({"jsonrpc":"2.0","id":2,"method":"no.such"},{"jsonrpc":"2.0","id":3,)"
      R"("method":"effect.pulse","params":{"direction":"sideways"}},)"
      R"({"jsonrpc":"2.0","id":4,"method":"ping"}])"
      "\n"));
  const Json responses = client_.response();
  ASSERT_EQ(responses.size(), 5u);
  EXPECT_TRUE(responses[0].contains("result"));
  EXPECT_EQ(responses[1]["error"]["code"], -32600);
  EXPECT_EQ(responses[1]["id"], nullptr);
  EXPECT_EQ(responses[2]["error"]["code"], -32601);
  EXPECT_EQ(responses[3]["error"]["code"], -32602);
  EXPECT_EQ(responses[4]["id"], 4);
}

TEST_F(InvalidInput, AHttpRequestIsRejected) {
  RawClient browser(daemon_.port());
  browser.send(
      "POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 60\r\n\r\n"
      R"({"jsonrpc":"2.0","method":"device.emergency_stop"})"
      "\n");
  EXPECT_TRUE(browser.closed_by_daemon());
  EXPECT_EQ(game_.call("device.status")["state"], "armed");
}

TEST_F(InvalidInput, AFloodWithoutReadingIsDisconnectedAndItsEffectsEnd) {
  RawClient watcher(daemon_.port());
  watcher.call("events.subscribe", {{"scope", "all"}, {"types", {"effect_ended"}}});
  RawClient flood(daemon_.port());
  flood.send(R"({"jsonrpc":"2.0","method":"effect.hold",)"
             R"("params":{"direction":"up","lease_ms":10000,"slot":"flood"}})"
             "\n");
  const std::string line = R"({"jsonrpc":"2.0","id":1,"method":"device.describe"})"
                           "\n";
  // The effect's lease is renewed for as long as the daemon reads.
  std::string lines = R"({"jsonrpc":"2.0","method":"effect.update","params":{"slot":"flood"}})"
                      "\n";
  for (int i = 0; i < 100; ++i) lines += line;
  bool open = true;
  for (int i = 0; i < 10'000 && open; ++i) {
    // Not every time: held requests cost the daemon nothing, and the game would flood control.
    if (i % 50 == 0) play_on();
    open = flood.send(lines);
  }
  EXPECT_FALSE(open);
  EXPECT_EQ(watcher.notification("event")["reason"], "disconnected");
  EXPECT_TRUE(daemon_.logs("does not read"));
}

}  // namespace
}  // namespace hedgehog::e2e
