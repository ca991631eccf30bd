// SPDX-License-Identifier: MIT
// One HTTP connection: requests and answers, until it closes or becomes a WebSocket. Boost.Beast
// takes the compiler half a minute: this header has none of it.
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

/// What the listener lends to its HTTP connections; outlives them. io thread only.
struct HttpEndpoint {
  Website site;
  Server& server;
  const config::ConnectionSettings& connections;
  /// The session of a new WebSocket, or nullopt at the limit of connections. With TLS it is locked.
  std::function<std::optional<Session>(boost::asio::ip::tcp::socket&, bool tls)> admit;
  /// It has.
  std::function<void(std::shared_ptr<Connection>)> enter;
};

/// Bounds: 8 KiB of headers, 1 KiB of body (none is ever needed), 30 s for a request to come.
boost::asio::awaitable<void> serve_http(boost::asio::ip::tcp::socket socket,
                                        HttpEndpoint& endpoint);
/// The same with TLS. `ticket` is given up when a good token has come.
boost::asio::awaitable<void> serve_https(boost::asio::ip::tcp::socket socket,
                                         HttpEndpoint& endpoint, TlsContext context,
                                         HalfOpen::Ticket ticket);

}  // namespace hedgehog::server
