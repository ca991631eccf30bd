// SPDX-License-Identifier: MIT
// The bytes of one client of a tunnel, to the ball and back.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <memory>
#include <string>

#include "clients/ctl/tunnel/ball_stream.h"

namespace hedgehog::client {

/// The first bytes that a client sends, without line ends before them; empty: it has closed, has
/// sent nothing within `time`, or does not speak JSON-RPC. The daemon checks the first byte of a
/// connection, because web pages can reach loopback; behind a tunnel it sees that of the tunnel's
/// hello. io thread only.
boost::asio::awaitable<std::string> first_bytes(boost::asio::ip::tcp::socket& client,
                                                std::chrono::milliseconds time);

/// Sends `first` and what follows from `client` to `ball`, and the responses back, until either end
/// closes, or has not accepted 16 KiB within `write_time`; then closes both. Buffers 16 KiB in each
/// direction, and reads no more until they are written. A client that closes only its direction
/// receives the last responses, for `response_timeout()` at most. io thread only.
boost::asio::awaitable<void> relay(boost::asio::ip::tcp::socket client,
                                   std::shared_ptr<BallStream> ball, std::string first,
                                   std::chrono::milliseconds write_time);

}  // namespace hedgehog::client
