// SPDX-License-Identifier: MIT
// One HTTP connection, until it closes or becomes a WebSocket. Does not include Boost.Beast.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <functional>
#include <memory>
#include <optional>

#include "daemon/server/net/connection.h"
#include "daemon/server/net/http/website.h"
#include "daemon/server/net/tls_context.h"

namespace hedgehog::server {

/// Dependencies of the HTTP connections, which it outlives. io thread only.
struct HttpEndpoint {
  Website site;
  Server& server;
  const config::ConnectionSettings& connections;
  /// The session of a new WebSocket, or nullopt at the limit of connections. With TLS it is locked.
  std::function<std::optional<Session>(boost::asio::ip::tcp::socket&, bool tls)> admit;
  std::function<void(std::shared_ptr<Connection>)> enter;  // registers an upgraded connection
};

/// Bounds: 8 KiB of headers, 1 KiB of body (none is ever needed), 30 s until a request is received.
boost::asio::awaitable<void> serve_http(boost::asio::ip::tcp::socket socket,
                                        HttpEndpoint& endpoint);
/// The same with TLS. `ticket` is released after a valid token.
boost::asio::awaitable<void> serve_https(boost::asio::ip::tcp::socket socket,
                                         HttpEndpoint& endpoint, TlsContext context,
                                         HalfOpen::Ticket ticket);

}  // namespace hedgehog::server
