// SPDX-License-Identifier: MIT
// An orderly stop while clients are in the middle of a message.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/web_client.h"

namespace hedgehog::e2e {
namespace {

TEST(Shutdown, WaitsForNoFurtherPartOfAMessage) {
  constexpr int kClients = 12;
  constexpr int kMessages = 9000;
  const Home home;
  DaemonProcess daemon(home);
  std::vector<std::unique_ptr<WebSocketClient>> clients;
  for (int i = 0; i < kClients; ++i)
    clients.push_back(std::make_unique<WebSocketClient>(daemon.http_port()));
  // Two parts each, so that one of them is often the last that was read; never answered.
  const std::string message = R"({"jsonrpc":"2.0","method":"ping"})";
  std::string all;
  for (int i = 0; i < kMessages; ++i)
    all += WebSocketClient::framed(WebSocketClient::kText, message.substr(0, 9), false) +
           WebSocketClient::framed(0, message.substr(9), true);
  for (const auto& client : clients) client->socket().send(all);
  EXPECT_EQ(daemon.stop(), 0) << daemon.log();
  std::puts(daemon.log().c_str());
}

}  // namespace
}  // namespace hedgehog::e2e
