// SPDX-License-Identifier: MIT
#include "daemon/server/net/accepted_socket.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "daemon/server/net/peer_of.h"
#include "daemon/server/net/tcp_acceptor.h"

namespace hedgehog::server {

namespace asio = boost::asio;
using boost::system::error_code;

namespace {

// An idle client whose computer has no power or no network any more is gone after 30 s: its place
// and its claim are free then. While data to it is unacknowledged nothing is probed, and the system
// gives up after a quarter of an hour; TCP_USER_TIMEOUT would also end clients that are stopped.
constexpr int kIdleS = 15;
constexpr int kProbeS = 5;
constexpr int kProbes = 3;

void probe_when_idle(asio::ip::tcp::socket& socket) noexcept {
  const auto set = [&](int level, int name, int value) {
    ::setsockopt(socket.native_handle(), level, name, &value, sizeof value);
  };
  set(SOL_SOCKET, SO_KEEPALIVE, 1);
  set(IPPROTO_TCP, TCP_KEEPIDLE, kIdleS);
  set(IPPROTO_TCP, TCP_KEEPINTVL, kProbeS);
  set(IPPROTO_TCP, TCP_KEEPCNT, kProbes);
}

}  // namespace

bool is_reset(const asio::ip::tcp::socket& socket) {
  error_code error;
  socket.remote_endpoint(error);
  return error.failed();
}

Session session_of(asio::ip::tcp::socket& socket) {
  error_code ignored;
  socket.set_option(asio::ip::tcp::no_delay(true), ignored);
  probe_when_idle(socket);
  Session session;
  session.transport = "tcp";
  const asio::ip::tcp::endpoint peer = socket.remote_endpoint(ignored);
  session.address = endpoint_text(peer);
  return session;
}

Session session_of(asio::local::stream_protocol::socket& socket) {
  Session session;
  session.transport = "unix";
  session.peer = peer_of(socket.native_handle());
  return session;
}

}  // namespace hedgehog::server
