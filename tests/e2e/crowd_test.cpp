// SPDX-License-Identifier: MIT
// More clients than the limit of connections.
#include <gtest/gtest.h>

#include <list>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/web_client.h"

namespace hedgehog::e2e {
namespace {

TEST(Crowd, OnTcpDoesNotBlockTheEmergencyStop) {
  const Home home;
  home.configure(R"({"connections": {"max": 3}})");
  DaemonProcess daemon(home);
  std::list<RawClient> crowd;
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(crowd.emplace_back(daemon.port()).call("ping").contains("time_ns"));
  EXPECT_EQ(RawClient(daemon.port()).response()["error"]["code"], -32001);

  WebSocketClient page(daemon.http_port());
  ASSERT_EQ(page.response().status, 101);
  EXPECT_EQ(page.call("device.emergency_stop")["state"], "disarmed");
  std::list<WebSocketClient> pages;
  for (int i = 1; i < 8; ++i)
    EXPECT_EQ(pages.emplace_back(daemon.http_port()).response().status, 101);
  EXPECT_EQ(WebSocketClient(daemon.http_port()).response().status, 503);
  EXPECT_EQ(web_get(daemon.http_port(), "/healthz").status, 200);

  std::list<RawClient> operators;
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(operators.emplace_back(daemon.socket()).call("device.arm")["state"], "armed");
  EXPECT_EQ(RawClient(daemon.socket()).response()["error"]["code"], -32001);
  EXPECT_EQ(operators.back().call("device.emergency_stop")["state"], "disarmed");
  crowd.clear();
  ASSERT_TRUE(eventually(
      [&] { return operators.back().call("connection.list")["connections"].size() == 8 + 8; }));
  EXPECT_EQ(RawClient(daemon.port()).response()["error"]["code"], -32001)
      << "pages and operators are clients too";
  operators.clear();
  pages.clear();
  EXPECT_EQ(daemon.stop(), 0);
}

}  // namespace
}  // namespace hedgehog::e2e
