// SPDX-License-Identifier: MIT
// What is known of a client when its socket has been accepted. io thread.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>

#include "daemon/server/session/session.h"

namespace hedgehog::server {

/// Reset before it was accepted: no client. One that only closed may have sent a request before.
bool is_reset(const boost::asio::ip::tcp::socket& socket);
inline bool is_reset(const boost::asio::local::stream_protocol::socket&) { return false; }

/// Transport, and address or peer. A TCP socket sends without delay, and is probed when it is idle
/// (SO_KEEPALIVE): after 30 s of silence a client that is unreachable is disconnected.
Session session_of(boost::asio::ip::tcp::socket& socket);
Session session_of(boost::asio::local::stream_protocol::socket& socket);

}  // namespace hedgehog::server
