// SPDX-License-Identifier: MIT
// Frames that RFC 6455 allows and frames that it forbids, section by section, and the response of
// /ws to each. Written from the RFC.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tests/e2e/web_fixture.h"

namespace hedgehog::e2e {
namespace {

using namespace std::string_literals;

constexpr int kContinuation = 0;
constexpr int kProtocolError = 1002;
constexpr int kBadPayload = 1007;
/// The connection ended without a close frame.
constexpr int kNoCode = -1;

/// A frame as sent: `first` is FIN, RSV1 to RSV3 and the opcode. Payload shorter than 126 bytes.
std::string frame_bytes(int first, std::string_view payload) {
  const std::string mask = "\x21\x43\x65\x07";
  std::string bytes{static_cast<char>(first), static_cast<char>(0x80 | payload.size())};
  bytes += mask;
  for (std::size_t i = 0; i < payload.size(); ++i)
    bytes += static_cast<char>(payload[i] ^ mask[i % 4]);
  return bytes;
}

std::string code_bytes(int code, const std::string& reason = {}) {
  return std::string{static_cast<char>(code >> 8), static_cast<char>(code)} + reason;
}

class WebSocketVectors : public Web {
 protected:
  /// The code of the next close frame; 0: it has none.
  static int close_code(WebSocketClient& client) {
    const auto frame = client.next();
    if (!frame) return kNoCode;
    EXPECT_EQ(frame->opcode, WebSocketClient::kClose) << frame->payload;
    if (frame->payload.size() < 2) return 0;
    return static_cast<unsigned char>(frame->payload[0]) << 8 |
           static_cast<unsigned char>(frame->payload[1]);
  }
  int code_after(const std::string& bytes) const {
    WebSocketClient client(daemon_.http_port());
    client.socket().send(bytes);
    return close_code(client);
  }
  static std::string request(const std::string& id) {
    return R"({"jsonrpc":"2.0","id":")" + id + R"(","method":"ping"})";
  }
};

// 5.2: lengths of 7, 16 and 64 bits.
TEST_F(WebSocketVectors, AMessageMayHaveAnyLength) {
  WebSocketClient client(daemon_.http_port());
  for (const std::size_t size : {125, 126, 127, 128, 65'535, 65'536}) {
    client.text(kPingRequest + std::string(size - kPingRequest.size(), ' '));
    EXPECT_TRUE(client.json().contains("result")) << size;
  }
  client.text("");
  EXPECT_EQ(client.json()["error"]["code"], -32700);
}

TEST_F(WebSocketVectors, AFrameMayArriveByteByByte) {
  WebSocketClient client(daemon_.http_port());
  for (const char byte : frame_bytes(0x81, kPingRequest))
    client.socket().send(std::string(1, byte));
  EXPECT_TRUE(client.json().contains("result"));
}

// 5.2: reserved bits are invalid without an extension, and reserved opcodes always.
TEST_F(WebSocketVectors, ReservedBitsAndOpcodesEndTheConnection) {
  for (const int reserved : {0x40, 0x20, 0x10, 0x70}) {
    EXPECT_EQ(code_after(frame_bytes(0x81 | reserved, kPingRequest)), kProtocolError) << reserved;
    EXPECT_EQ(code_after(frame_bytes(0x89 | reserved, "")), kProtocolError) << reserved;
  }
  for (const int opcode : {3, 4, 5, 6, 7, 11, 12, 13, 14, 15})
    EXPECT_EQ(code_after(frame_bytes(0x80 | opcode, "")), kProtocolError) << opcode;
}

// 5.4: fragments, and the frames allowed between them.
TEST_F(WebSocketVectors, FragmentsFollowEachOtherWithControlFramesBetween) {
  WebSocketClient client(daemon_.http_port());
  for (std::size_t i = 0; i < kPingRequest.size(); ++i) {
    client.frame(i == 0 ? WebSocketClient::kText : kContinuation, kPingRequest.substr(i, 1), false);
    if (i % 10 == 0) client.frame(WebSocketClient::kPong, "unasked");
  }
  client.frame(kContinuation, "");
  EXPECT_TRUE(client.json().contains("result"));
  EXPECT_EQ(code_after(frame_bytes(0x80, "x")), kProtocolError) << "of nothing";
  EXPECT_EQ(code_after(frame_bytes(0x00, "x")), kProtocolError);
  EXPECT_EQ(code_after(frame_bytes(0x01, "{") + frame_bytes(0x81, "}")), kProtocolError)
      << "another message before the end of the first";
}

// 5.5: control frames are short and not fragmented.
TEST_F(WebSocketVectors, ControlFramesAreShortAndWhole) {
  WebSocketClient client(daemon_.http_port());
  for (const std::string& payload : {""s, "hello"s, "\x00\xff\xfe\xfd"s, std::string(125, 'x')}) {
    client.frame(WebSocketClient::kPing, payload);
    const auto pong = client.next();
    ASSERT_TRUE(pong);
    EXPECT_EQ(pong->opcode, WebSocketClient::kPong);
    EXPECT_EQ(pong->payload, payload);
  }
  for (const int opcode : {WebSocketClient::kPing, WebSocketClient::kPong}) {
    EXPECT_EQ(code_after(frame_bytes(opcode, "")), kProtocolError) << "a part of " << opcode;
    WebSocketClient longer(daemon_.http_port());
    longer.frame(opcode, std::string(126, 'x'));
    EXPECT_EQ(close_code(longer), kProtocolError) << "a long " << opcode;
  }
}

// 8.1: text is UTF-8, at any fragment boundary.
TEST_F(WebSocketVectors, TextIsUtf8AcrossItsFragments) {
  WebSocketClient client(daemon_.http_port());
  for (const std::string& id : {"κόσμε"s, "\u20ac"s, "\U0010ffff"s, "\ufffe\ufdd0"s, "\x7f"s}) {
    const std::string text = request(id);
    for (std::size_t i = 0; i < text.size(); ++i) {
      client.frame(i == 0 ? WebSocketClient::kText : kContinuation, text.substr(i, 1),
                   i + 1 == text.size());
    }
    EXPECT_EQ(client.json()["id"], id);
  }
  for (const std::string& wrong :
       {"\x80"s, "\xc0\xaf"s, "\xc3"s, "\xe0\x80\xaf"s, "\xe2\x82"s, "\xed\xa0\x80"s,
        "\xf0\x80\x80\xaf"s, "\xf4\x90\x80\x80"s, "\xf8\x88\x80\x80\x80"s, "\xfe"s, "\xff"s}) {
    EXPECT_EQ(code_after(frame_bytes(0x81, request(wrong))), kBadPayload);
    EXPECT_EQ(code_after(frame_bytes(0x81, wrong)), kBadPayload) << "at the end";
  }
  EXPECT_EQ(code_after(frame_bytes(0x01, "\xce") + frame_bytes(0x80, "x")), kBadPayload);
}

// 5.5.1 and 7.4: a close is answered by a close; its code, if it has one, is a valid one.
TEST_F(WebSocketVectors, ACloseIsAnsweredAndItsCodeIsOneThatMayBeSent) {
  for (const int code :
       {1000, 1001, 1002, 1003, 1007, 1008, 1009, 1010, 1011, 3000, 3999, 4000, 4999})
    EXPECT_EQ(code_after(frame_bytes(0x88, code_bytes(code))), code);
  EXPECT_EQ(code_after(frame_bytes(0x88, code_bytes(1000, std::string(123, 'x')))), 1000);
  const int none = code_after(frame_bytes(0x88, ""));
  EXPECT_TRUE(none == 0 || none == 1000) << none;
  for (const int code : {0, 999, 1004, 1005, 1006, 1015, 1016, 1100, 2000, 2999})
    EXPECT_EQ(code_after(frame_bytes(0x88, code_bytes(code))), kProtocolError) << code;
  EXPECT_EQ(code_after(frame_bytes(0x88, "\x03")), kProtocolError) << "half a code";
  const int reason = code_after(frame_bytes(0x88, code_bytes(1000, "\xff")));
  EXPECT_TRUE(reason == kProtocolError || reason == kBadPayload) << reason;
}

TEST_F(WebSocketVectors, NothingIsAnsweredAfterAClose) {
  WebSocketClient client(daemon_.http_port());
  client.socket().send(frame_bytes(0x88, code_bytes(1000)) + frame_bytes(0x81, kPingRequest) +
                       frame_bytes(0x89, ""));
  EXPECT_EQ(close_code(client), 1000);
  EXPECT_FALSE(client.next());
}

}  // namespace
}  // namespace hedgehog::e2e
