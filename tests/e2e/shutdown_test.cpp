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

TEST(Shutdown, ReadsNoFurtherPartOfAMessage) {
  constexpr int kClients = 12;
  constexpr int kCycles = 6000;  // of one message of nearly 64 KiB that never ends
  constexpr int kParts = 10;
  std::string cycle;
  for (int i = 0; i < kParts; ++i) cycle += WebSocketClient::framed(0, " ", false);
  for (int i = 0; i < kParts; ++i)
    cycle += WebSocketClient::framed(WebSocketClient::kPong, "", true);
  std::string parts = WebSocketClient::framed(WebSocketClient::kText, " ", false);
  for (int i = 0; i < kCycles; ++i) parts += cycle;

  const Home home;
  DaemonProcess daemon(home);
  std::vector<std::unique_ptr<WebSocketClient>> clients;
  for (int i = 0; i < kClients; ++i)
    clients.push_back(std::make_unique<WebSocketClient>(daemon.http_port()));
  for (const auto& client : clients) client->socket().send(parts);
  EXPECT_EQ(daemon.stop(), 0) << daemon.log();
}

}  // namespace
}  // namespace hedgehog::e2e
