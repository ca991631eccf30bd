// SPDX-License-Identifier: MIT
// Reading from a client that sends faster than it reads is slowed down; the client is not
// disconnected.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <string>

#include "tests/e2e/program.h"
#include "tests/e2e/web_fixture.h"

namespace hedgehog::e2e {
namespace {

constexpr int kMany = 1000;
/// For WebSocket, whose requests here have smaller responses: 2 MB in total as well.
constexpr int kFrames = 1500;
/// Its response is 10 kB; the one to `kStatus` fits into one frame.
const std::string kDescribe = R"({"jsonrpc":"2.0","id":7,"method":"device.describe"})";
const std::string kStatus = R"({"jsonrpc":"2.0","id":7,"method":"device.status"})";

class BackPressure : public Web {
 protected:
  /// Expects a response to each of `count` requests sent at once, while another client keeps
  /// playing.
  void expect_responses(const std::function<Json()>& next, int count = kMany) {
    RawClient game(daemon_.port());
    for (int i = 0; i < count; ++i) {
      const Json response = next();
      ASSERT_EQ(response["id"], 7) << i;
      ASSERT_TRUE(response["result"].contains("simulated")) << i;
      if (i % 100 == 0) EXPECT_TRUE(game.call("ping").contains("time_ns"));
    }
    EXPECT_LE(metric(R"(hedgehog_connections_rejected_total{device="ball",reason="slow"})"), 0)
        << "nobody was cut";
  }
  static std::string requests() {
    std::string all;
    for (int i = 0; i < kMany; ++i) all += kDescribe + "\n";
    return all;
  }
};

TEST_F(BackPressure, OnTcpAThousandRequestsAtOnceAreAnswered) {
  RawClient client(daemon_.port());
  client.send(requests());
  expect_responses([&] { return client.response(); });
}

TEST_F(BackPressure, OnTheUnixSocketToo) {
  RawClient client(daemon_.socket());
  client.send(requests());
  expect_responses([&] { return client.response(); });
}

TEST_F(BackPressure, OnWebSocketToo) {
  WebSocketClient client(daemon_.http_port());
  for (int i = 0; i < kFrames; ++i) client.text(kStatus);
  expect_responses([&] { return client.json(); }, kFrames);
}

TEST_F(BackPressure, RequestsThatWaitForATickAreAnsweredToo) {
  RawClient client(daemon_.port());
  std::string all;
  for (int i = 0; i < kMany; ++i)
    all += R"({"jsonrpc":"2.0","id":7,"method":"device.arm"})"
           "\n";
  client.send(all);
  for (int i = 0; i < kMany; ++i) ASSERT_EQ(client.response()["id"], 7) << i;
}

TEST_F(BackPressure, RequestsSentBeforeAHalfCloseAreAnswered) {
  RawClient client(daemon_.port());
  client.send(requests());
  client.half_close();
  expect_responses([&] { return client.response(); });
  EXPECT_TRUE(client.closed_by_daemon());
}

TEST(HalfClose, LeavesASlowReaderItsResponses) {
  constexpr std::size_t kBatch = 64;  // 640 kB: more than the system buffers
  const Home home;
  home.configure(R"({"connections": {"queue_bytes": 16777216}})");
  const DaemonProcess daemon(home);
  std::string batch = kDescribe;
  for (std::size_t i = 1; i < kBatch; ++i) batch += "," + kDescribe;
  RawClient client(daemon.port(), 4096);
  client.send("[" + batch + "]\n");
  client.half_close();
  ASSERT_TRUE(client.bytes(1).has_value());
  // Longer than a client that is closed has for the rest.
  const auto begun = std::chrono::steady_clock::now();
  ASSERT_TRUE(eventually(
      [&] { return std::chrono::steady_clock::now() - begun > std::chrono::milliseconds(1500); }));
  const auto rest = client.line();
  ASSERT_TRUE(rest.has_value()) << "the responses end in the middle";
  EXPECT_EQ(Json::parse("[" + *rest).size(), kBatch);
  EXPECT_TRUE(client.closed_by_daemon());
}

}  // namespace
}  // namespace hedgehog::e2e
