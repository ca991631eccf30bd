// SPDX-License-Identifier: MIT
// A client on a WebSocket: one message a frame, the rest as on TCP. For source files with Beast
// only.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include "daemon/server/net/http/http_connection.h"
#include "daemon/server/net/http/http_stream.h"

namespace hedgehog::server {

using UpgradeRequest = boost::beast::http::request<boost::beast::http::string_body>;

/// Answers `request`, and `stream` is a connection of the server's from then on, which keeps
/// `ticket` as long as it is locked. io thread.
boost::asio::awaitable<void> become_web_socket(HttpStream stream, UpgradeRequest request,
                                               Session session, HttpEndpoint& endpoint,
                                               HalfOpen::Ticket ticket);

}  // namespace hedgehog::server
