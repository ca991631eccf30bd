// SPDX-License-Identifier: MIT
#include "daemon/server/net/accepted_socket.h"

#include "daemon/server/net/peer_of.h"
#include "daemon/server/net/tcp_acceptor.h"

namespace hedgehog::server {

namespace asio = boost::asio;
using boost::system::error_code;

bool is_reset(const asio::ip::tcp::socket& socket) {
  error_code error;
  socket.remote_endpoint(error);
  return error.failed();
}

Session session_of(asio::ip::tcp::socket& socket) {
  error_code ignored;
  socket.set_option(asio::ip::tcp::no_delay(true), ignored);
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
