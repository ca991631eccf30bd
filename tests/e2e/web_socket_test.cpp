// SPDX-License-Identifier: MIT
// /ws is the same protocol as TCP, errors included.
#include <gtest/gtest.h>

#include <string>

#include "tests/e2e/web_fixture.h"

namespace hedgehog::e2e {
namespace {

using WebSocket = Web;

TEST_F(WebSocket, HasTheSameProtocolAsTcp) {
  WebSocketClient web(daemon_.http_port());
  RawClient tcp(daemon_.port());
  ASSERT_EQ(web.response().status, 101);
  Json hello = web.call("hello", {{"client", "page"}});
  EXPECT_EQ(hello["role"], "operate");
  Json other = tcp.call("hello", {{"client", "page"}});
  for (Json* result : {&hello, &other}) {
    result->erase("connection");
    // By the present temperatures.
    EXPECT_EQ((*result)["limits"].erase("burst_s"), 1u);
  }
  EXPECT_EQ(hello, other);
  for (const std::string line :
       {"{", "", "[]", "{}", R"({"jsonrpc":"2.0","id":1,"method":"no.such"})",
        R"([{"jsonrpc":"2.0","id":1,"method":"no.such"},7])",
        R"({"jsonrpc":"2.0","id":7,"method":"effect.pulse","params":{"direction":"sideways"}})",
        R"({"jsonrpc":"2.0","id":7,"method":"effect.stop","params":{"effect":9}})"}) {
    web.text(line);
    tcp.send(line + "\n");
    EXPECT_EQ(web.json(), tcp.response()) << line;
  }
  const Json info = tcp.call("connection.list")["connections"];
  ASSERT_EQ(info.size(), 2u);
  EXPECT_EQ(info[0]["transport"], "websocket");
  EXPECT_EQ(info[0]["client"], "page");
  EXPECT_EQ(metric(R"(hedgehog_connections{device="ball",transport="websocket"})"), 1);
}

TEST_F(WebSocket, ANulEndsNoMessage) {
  WebSocketClient web(daemon_.http_port());
  web.text(kPingRequest + std::string(1, '\0') + " garbage");
  EXPECT_EQ(web.json()["error"]["code"], -32700);
}

TEST_F(WebSocket, TextThatIsNotUtf8ClosesTheConnection) {
  WebSocketClient web(daemon_.http_port());
  web.text("{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"\xff\"}");
  const auto closed = web.next();
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->opcode, WebSocketClient::kClose);
  EXPECT_EQ(closed->payload.substr(0, 2), std::string("\x03\xef")) << "1007";
}

TEST_F(WebSocket, AMessageMayComeInFragmentsWithAPingInBetween) {
  WebSocketClient web(daemon_.http_port());
  web.frame(WebSocketClient::kText, kPingRequest.substr(0, 9), false);
  web.frame(WebSocketClient::kPing, "are you there");
  web.frame(0, kPingRequest.substr(9, 1), false);
  web.frame(0, kPingRequest.substr(10));
  const auto pong = web.next();
  ASSERT_TRUE(pong);
  EXPECT_EQ(pong->opcode, WebSocketClient::kPong);
  EXPECT_EQ(pong->payload, "are you there");
  EXPECT_TRUE(web.json()["result"].contains("time_ns"));
}

TEST_F(WebSocket, AMessageOf64KiBIsServedAndALongerOneIsOneError) {
  WebSocketClient web(daemon_.http_port());
  web.text(kPingRequest + std::string(kMaxLine - kPingRequest.size(), ' '));
  EXPECT_TRUE(web.json().contains("result"));
  web.text(kPingRequest + std::string(kMaxLine + 1 - kPingRequest.size(), ' '));
  EXPECT_EQ(web.json()["error"]["code"], -32700);
  // A megabyte in fragments, which is discarded.
  for (int i = 0; i < 64; ++i)
    web.frame(i == 0 ? WebSocketClient::kText : 0, std::string(16 * 1024, 'x'), i == 63);
  EXPECT_EQ(web.json()["error"]["code"], -32700);
  EXPECT_TRUE(web.call("ping").contains("time_ns"));
}

TEST_F(WebSocket, InvalidFramesEndTheConnectionOnly) {
  WebSocketClient binary(daemon_.http_port());
  binary.frame(WebSocketClient::kBinary, "{}");
  EXPECT_EQ(binary.next().value_or(WebSocketClient::Frame{}).opcode, WebSocketClient::kClose);
  WebSocketClient broken(daemon_.http_port());
  broken.socket().send(std::string(20, '\xff'));
  const auto end = broken.next();
  EXPECT_TRUE(!end || end->opcode == WebSocketClient::kClose);
  WebSocketClient unmasked(daemon_.http_port());
  unmasked.socket().send(std::string("\x81\x02{}"));
  const auto closed = unmasked.next();
  EXPECT_TRUE(!closed || closed->opcode == WebSocketClient::kClose);
  EXPECT_EQ(get("/healthz").status, 200);
}

TEST_F(WebSocket, EffectsEndWithTheirSocketHoweverItEnds) {
  RawClient watcher(daemon_.port());
  watcher.call("events.subscribe", {{"scope", "all"}, {"types", {"effect_ended"}}});
  const Json hold{{"direction", "left"}, {"lease_ms", 10000}};
  const auto ended = [&] { return watcher.notification("event")["reason"]; };
  {
    WebSocketClient web(daemon_.http_port());
    web.call("effect.hold", hold);
  }
  EXPECT_EQ(ended(), "disconnected");
  {
    WebSocketClient web(daemon_.http_port());
    web.call("effect.hold", {{"direction", "left"}, {"lease_ms", 5000}});
    web.frame(WebSocketClient::kBinary, "{}");
    EXPECT_EQ(ended(), "disconnected") << "before the client has answered the daemon's close";
    EXPECT_EQ(web.next().value_or(WebSocketClient::Frame{}).payload.substr(0, 2), "\x03\xeb")
        << "1003: it sends what cannot be used";
  }
  {
    WebSocketClient web(daemon_.http_port());
    web.call("effect.hold", hold);
    web.socket().half_close();
    EXPECT_EQ(ended(), "disconnected");
  }
  WebSocketClient web(daemon_.http_port());
  web.call("effect.hold", hold);
  web.frame(WebSocketClient::kClose, std::string("\x03\xe8", 2));
  EXPECT_EQ(ended(), "disconnected");
  EXPECT_EQ(web.next().value_or(WebSocketClient::Frame{}).opcode, WebSocketClient::kClose);
}

TEST_F(WebSocket, AShutdownIsAnnouncedAndTheSocketClosed) {
  WebSocketClient web(daemon_.http_port());
  web.call("events.subscribe", {{"types", {"shutting_down"}}});
  daemon_.signal(SIGTERM);
  EXPECT_EQ(web.json()["params"]["type"], "shutting_down");
  const auto close_frame = web.next();
  ASSERT_TRUE(close_frame);
  EXPECT_EQ(close_frame->opcode, WebSocketClient::kClose);
  EXPECT_EQ(daemon_.stop(), 0);
}

}  // namespace
}  // namespace hedgehog::e2e
