// SPDX-License-Identifier: MIT
// The game's connection to a daemon: one that refuses it, one that sends many messages at once.
#include "clients/racer/feel/ball_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/asio.hpp>
#include <future>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "tests/clients/fake_daemon.h"

namespace hedgehog::racer {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Clock = BallLink::Clock;
using client::FakeDaemon;
using client::FakePeer;
using nlohmann::json;

constexpr const char* kHello = R"({"server": "hedgehogd", "version": "1", "protocol": "1.0",
  "connection": 1, "role": "operate", "state": "armed", "reason": null, "remedy": null,
  "methods": [], "device": {"name": "ball", "model": "hedgehog-86", "simulated": true},
  "limits": {"current_a": 15, "continuous_a": 5, "felt_a": 2.1, "duration_ms": 10000,
    "lease_ms": 10000, "effects": 32, "frequency_hz": 250, "telemetry_hz": 200,
    "line_bytes": 65536}})";

void respond(FakePeer& peer, const json& result) {
  const json id = json::parse(peer.read())["id"];
  peer.send_line(json{{"jsonrpc", "2.0"}, {"id", id}, {"result", result}}.dump());
}

/// Answers hello and telemetry.subscribe, sends `count` telemetry messages at once, sets `sent`,
/// and waits until the client disconnects.
FakeDaemon::Script send_all(int count, std::promise<void>& sent) {
  return [count, &sent](FakePeer& peer) {
    respond(peer, json::parse(kHello));
    respond(peer, {{"rate_hz", 60}, {"fields", {"time_ns"}}});
    std::string lines;
    for (int i = 0; i < count; ++i)
      lines += R"({"jsonrpc":"2.0","method":"telemetry","params":{"time_ns":)" + std::to_string(i) +
               "}}\n";
    peer.send(lines);
    sent.set_value();
    peer.read();
  };
}

TEST(BallLink, RetriesARefusingDaemonWithBackoff) {
  asio::io_context io;
  tcp::acceptor acceptor(io, {asio::ip::address_v4::loopback(), std::uint16_t{0}});
  acceptor.non_blocking(true);
  std::vector<Clock::time_point> attempts;
  std::set<std::string> problems;
  BallLink link({{.host = "127.0.0.1", .port = acceptor.local_endpoint().port()}});
  // Back-off of 0.1 + 0.2 + 0.4 s.
  const auto give_up = Clock::now() + std::chrono::seconds(20);
  while (attempts.size() < 4 && Clock::now() < give_up) {
    link.listen();
    problems.insert(link.problem());
    EXPECT_FALSE(link.is_receiving());
    boost::system::error_code none;
    tcp::socket game(io);
    acceptor.accept(game, none);
    if (!none) {
      attempts.push_back(Clock::now());
      asio::write(
          game,
          asio::buffer(std::string(
              R"({"jsonrpc":"2.0","id":null,"error":{"code":-32001,"message":"busy: too many","data":{"name":"busy"}}})"
              "\n")));
      game.shutdown(tcp::socket::shutdown_send, none);
      asio::streambuf rest;
      game.non_blocking(false);
      asio::read(game, rest, none);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_EQ(attempts.size(), 4U);
  EXPECT_GE(attempts[3] - attempts[0], std::chrono::milliseconds(600));
  EXPECT_TRUE(problems.contains("busy: too many"));
}

TEST(BallLink, ReadsABoundedNumberOfMessagesInAFrameAndTheRestInTheNext) {
  constexpr int kMessages = 250;
  std::promise<void> sent;
  const FakeDaemon daemon(send_all(kMessages, sent));
  BallLink link({daemon.address()});
  ASSERT_EQ(sent.get_future().wait_for(client::kLongTimeout), std::future_status::ready);
  std::size_t max_per_frame = 0;
  std::vector<std::int64_t> times;
  const auto give_up = Clock::now() + client::kLongTimeout;
  while (times.size() < kMessages && Clock::now() < give_up) {
    const auto received = link.listen();
    max_per_frame = std::max(max_per_frame, received.statuses.size());
    for (const auto& status : received.statuses) times.push_back(status.time_ns);
    std::this_thread::yield();
  }
  std::vector<std::int64_t> expected(kMessages);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(times, expected) << link.problem();
  EXPECT_LE(max_per_frame, 100U);
}

}  // namespace
}  // namespace hedgehog::racer
