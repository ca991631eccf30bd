// SPDX-License-Identifier: MIT
// Clients of a tunnel that keep their place without using it.
#include <unistd.h>

#include <csignal>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "clients/ctl/tunnel/tunnel.h"
#include "tests/e2e/tunnel_fixture.h"

namespace hedgehog::e2e {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kShort{50};

/// A tunnel in this process, with limits that a test can await.
class TunnelDeadline : public TunnelFixture {
 protected:
  ~TunnelDeadline() override {
    if (!thread_.joinable()) return;
    ::kill(::getpid(), SIGTERM);
    thread_.join();
  }
  void run(const client::Tunnel::Limits& limits) {
    const std::vector<std::string> all = variables(play_);
    const auto environment = [&](const std::string& name) -> std::optional<std::string> {
      for (const std::string& one : all)
        if (one.starts_with(name + "=")) return one.substr(name.size() + 1);
      return std::nullopt;
    };
    tunnel_ = std::make_unique<client::Tunnel>(
        client::daemon_addresses({}, environment).value(), [](const client::ClientError&) {},
        limits);
    port_ = tunnel_->listen(0).value();
    thread_ = std::thread([this] { tunnel_->run(); });
  }

  int port_ = 0;
  std::unique_ptr<client::Tunnel> tunnel_;
  std::thread thread_;
};

TEST_F(TunnelDeadline, AClientThatSendsNothingIsClosed) {
  run({.first_request = kShort});
  RawClient silent(port_);
  EXPECT_TRUE(silent.closed_by_daemon());
}

TEST_F(TunnelDeadline, AClientThatHasSentARequestStays) {
  run({.first_request = kShort});
  std::optional<RawClient> game;
  // A busy machine may take longer than that to send the first one.
  ASSERT_TRUE(eventually([&] {
    game.emplace(port_);
    game->send(R"({"jsonrpc":"2.0","id":0,"method":"ping"})"
               "\n");
    return game->line().has_value();
  }));
  EXPECT_TRUE(RawClient(port_).closed_by_daemon()) << "the time has passed";
  EXPECT_TRUE(game->call("ping").contains("time_ns"));
}

TEST_F(TunnelDeadline, AClientThatDoesNotReadIsClosed) {
  daemon_.reset();
  home_.configure(R"({"http": {"listen": null}, "connections": {"write_timeout_s": 600}})");
  start("tls://127.0.0.1:0");
  // Long enough for the connection to be seen.
  run({.write = std::chrono::seconds(2)});
  RawClient game(port_);
  game.send(many_requests());
  const auto connections = [&] {
    return RawClient(daemon_->socket()).call("connection.list")["connections"].dump();
  };
  const std::string name = "\"hedgehogctl tunnel\"";
  EXPECT_TRUE(eventually([&] { return connections().find(name) != std::string::npos; }));
  EXPECT_TRUE(eventually([&] { return connections().find(name) == std::string::npos; }))
      << connections();
}

}  // namespace
}  // namespace hedgehog::e2e
