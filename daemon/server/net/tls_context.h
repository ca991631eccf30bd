// SPDX-License-Identifier: MIT
// What TLS connections of the daemon have in common.
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <memory>

#include "daemon/config/config.h"

namespace hedgehog::server {

using TlsContext = std::shared_ptr<boost::asio::ssl::context>;

/// With certificate and key of `access`; nullptr: it has none. Only TLS 1.3, which knows no
/// renegotiation. Sessions are not resumed, so there is no early data, which could be replayed, and
/// no key that decrypts the tickets of earlier connections. Throws std::exception.
TlsContext make_tls_context(const config::AccessSettings& access);

}  // namespace hedgehog::server
