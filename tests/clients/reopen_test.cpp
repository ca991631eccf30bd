// SPDX-License-Identifier: MIT
// Repeated attempts to connect: how long they go on, and which errors end them.
#include <gtest/gtest.h>

#include <thread>

#include "clients/lib/backoff.h"
#include "clients/lib/connection.h"
#include "tests/clients/fake_daemon.h"

namespace hedgehog::client {
namespace {

using namespace std::chrono_literals;

TEST(Reopen, FailsAfterItsTimeout) {
  const auto none = Connection::reopen({SilentPort().address()}, 250ms);
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().failure, Failure::kNoDaemon);
}

TEST(Reopen, ConnectsWhenTheDaemonRunsAgain) {
  boost::asio::io_context io;
  boost::asio::ip::tcp::acceptor acceptor(io, boost::asio::ip::tcp::v4());
  acceptor.bind({boost::asio::ip::address_v4::loopback(), 0});
  const Address address{.host = "127.0.0.1", .port = acceptor.local_endpoint().port()};
  ASSERT_FALSE(Connection::open({address}, 200ms).has_value());
  std::thread later([&] {
    std::this_thread::sleep_for(150ms);
    acceptor.listen();
  });
  EXPECT_TRUE(Connection::reopen({address}, kLongTimeout).has_value());
  later.join();
}

TEST(Reopen, EndsWithARefusedToken) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(
        R"({"jsonrpc":"2.0","id":1,"error":{"code":-32003,"message":"token: unknown or revoked"}})");
  });
  Address address = daemon.address();
  address.token = "wrong";
  const auto refused = Connection::reopen({address}, kLongTimeout);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().failure, Failure::kRefused);
  EXPECT_EQ(refused.error().message, "token: unknown or revoked");
}

TEST(MayConnectLater, IsUpToTimeAlone) {
  using enum protocol::ErrorCode;
  const auto refused = [](protocol::ErrorCode code, std::optional<std::int64_t> after_ms = {}) {
    return ClientError{
        Failure::kRefused, "no",
        protocol::RpcError{.code = code, .message = "no", .retry_after_ms = after_ms}};
  };
  for (const auto failure : {Failure::kNoDaemon, Failure::kClosed, Failure::kTimeout})
    EXPECT_TRUE(may_connect_later({failure, "no", {}}));
  EXPECT_FALSE(may_connect_later({Failure::kBadAddress, "no", {}}));
  EXPECT_FALSE(may_connect_later({Failure::kRefused, "no", {}}));
  EXPECT_TRUE(may_connect_later(refused(kBusy)));
  EXPECT_TRUE(may_connect_later(refused(kUnauthorized, 1000)));
  EXPECT_FALSE(may_connect_later(refused(kUnauthorized)));
  EXPECT_FALSE(may_connect_later(refused(kNotArmed, 1000)));

  EXPECT_EQ(retry_after(refused(kBusy, 1000)), 1000ms);
  EXPECT_EQ(retry_after(refused(kBusy)), 0ms);
  EXPECT_EQ(retry_after(refused(kBusy, 3'600'000)), 60'000ms);
}

TEST(Backoff, DoublesFromATenthOfASecondToFive) {
  Backoff backoff;
  for (const int expected : {100, 200, 400, 800, 1600, 3200, 5000, 5000})
    EXPECT_EQ(backoff.next(), Milliseconds(expected));
  backoff.reset();
  EXPECT_EQ(backoff.next(), 100ms);
}

}  // namespace
}  // namespace hedgehog::client
