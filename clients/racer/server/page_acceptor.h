// SPDX-License-Identifier: MIT
// Opens the port of the game's page.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>

#include "clients/racer/server/hub.h"

namespace hedgehog::racer {

/// Listens on `settings.address` and `settings.port`. The page has neither TLS nor a token, so only
/// addresses of loopback are accepted. std::runtime_error with a sentence if that fails.
boost::asio::ip::tcp::acceptor open_acceptor(boost::asio::io_context& context,
                                             const HubSettings& settings);

}  // namespace hedgehog::racer
