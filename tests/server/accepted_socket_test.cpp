// SPDX-License-Identifier: MIT
// The options of an accepted TCP socket.
#include "daemon/server/net/accepted_socket.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <boost/asio/io_context.hpp>

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

int option(tcp::socket& socket, int level, int name) {
  int value = -1;
  socklen_t size = sizeof value;
  EXPECT_EQ(::getsockopt(socket.native_handle(), level, name, &value, &size), 0);
  return value;
}

TEST(AcceptedSocket, OfAnIdleClientIsProbedForHalfAMinute) {
  asio::io_context io;
  tcp::acceptor acceptor(io, {asio::ip::address_v4::loopback(), 0});
  tcp::socket client(io);
  client.connect(acceptor.local_endpoint());
  tcp::socket accepted = acceptor.accept();
  EXPECT_EQ(session_of(accepted).transport, "tcp");
  EXPECT_NE(option(accepted, IPPROTO_TCP, TCP_NODELAY), 0);
  EXPECT_NE(option(accepted, SOL_SOCKET, SO_KEEPALIVE), 0);
  EXPECT_EQ(
      option(accepted, IPPROTO_TCP, TCP_KEEPIDLE) +
          option(accepted, IPPROTO_TCP, TCP_KEEPCNT) * option(accepted, IPPROTO_TCP, TCP_KEEPINTVL),
      30);
}

}  // namespace
}  // namespace hedgehog::server
