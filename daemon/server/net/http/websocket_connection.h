// SPDX-License-Identifier: MIT
// A client on a WebSocket: one message per frame, otherwise as on TCP. Only for files with Beast.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include "daemon/server/net/http/http_connection.h"
#include "daemon/server/net/http/http_stream.h"

namespace hedgehog::server {

using UpgradeRequest = boost::beast::http::request<boost::beast::http::string_body>;

/// Responds to `request`, after which `stream` is a connection of the server, which keeps `ticket`
/// while it is locked. io thread.
boost::asio::awaitable<void> become_web_socket(HttpStream stream, UpgradeRequest request,
                                               Session session, HttpEndpoint& endpoint,
                                               HalfOpen::Ticket ticket);

}  // namespace hedgehog::server
