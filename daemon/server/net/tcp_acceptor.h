// SPDX-License-Identifier: MIT
// A listening TCP socket.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <optional>
#include <string>

#include "daemon/config/listen_address.h"
#include "daemon/server/net/inherited_sockets.h"

namespace hedgehog::server {

/// Listens at `wanted`, with the socket of `inherited` if there is one. nullopt: this machine has
/// no IPv6. Throws std::runtime_error with a sentence for display, in which `remedy` is the setting
/// of the port; also for an address without TLS that other machines could reach.
std::optional<boost::asio::ip::tcp::acceptor> open_acceptor(boost::asio::io_context& io,
                                                            const config::ListenAddress& wanted,
                                                            InheritedSockets& inherited,
                                                            const char* remedy);

/// As in the configuration: "127.0.0.1:7586", "[::1]:7586".
std::string endpoint_text(const boost::asio::ip::tcp::endpoint& endpoint);

}  // namespace hedgehog::server
