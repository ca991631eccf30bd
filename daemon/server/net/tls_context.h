// SPDX-License-Identifier: MIT
// Shared TLS context of the daemon's connections.
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <memory>

#include "daemon/config/config.h"

namespace hedgehog::server {

using TlsContext = std::shared_ptr<boost::asio::ssl::context>;

/// With certificate and key of `access`; nullptr: none. Only TLS 1.3, without resumption: no early
/// data, which could be replayed, and no key of earlier tickets. Throws std::exception.
TlsContext make_tls_context(const config::AccessSettings& access);

}  // namespace hedgehog::server
