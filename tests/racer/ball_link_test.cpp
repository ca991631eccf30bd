// SPDX-License-Identifier: MIT
// The game's line to a daemon that does not want it.
#include "clients/racer/feel/ball_link.h"

#include <gtest/gtest.h>

#include <boost/asio.hpp>
#include <set>
#include <thread>
#include <vector>

namespace hedgehog::racer {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Clock = BallLink::Clock;

TEST(BallLink, AsksADaemonThatRefusesItAgainAfterLongerAndLongerPauses) {
  asio::io_context io;
  tcp::acceptor acceptor(io, {asio::ip::address_v4::loopback(), std::uint16_t{0}});
  acceptor.non_blocking(true);
  std::vector<Clock::time_point> came;
  std::set<std::string> troubles;
  BallLink link({{.host = "127.0.0.1", .port = acceptor.local_endpoint().port()}});
  // 0.1 + 0.2 + 0.4 s of pauses.
  const auto give_up = Clock::now() + std::chrono::seconds(20);
  while (came.size() < 4 && Clock::now() < give_up) {
    link.listen();
    troubles.insert(link.trouble());
    EXPECT_FALSE(link.hears());
    boost::system::error_code none;
    tcp::socket game(io);
    acceptor.accept(game, none);
    if (!none) {
      came.push_back(Clock::now());
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
  ASSERT_EQ(came.size(), 4U);
  EXPECT_GE(came[3] - came[0], std::chrono::milliseconds(600));
  EXPECT_TRUE(troubles.contains("busy: too many"));
}

}  // namespace
}  // namespace hedgehog::racer
