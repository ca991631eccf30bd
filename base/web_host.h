// SPDX-License-Identifier: MIT
// Checks of the names that a browser sends. Any web page can reach loopback: a foreign site is
// detected by its `Origin`, DNS rebinding by its `Host`. Pure functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hedgehog::base {

/// The parts of a `Host` header.
struct WebHost {
  std::string name;  // lower case, an IPv6 address in brackets
  std::optional<std::string> port{};

  bool is_v4() const;
  /// "localhost", an address 127.x.x.x or "[::1]".
  bool is_loopback() const;
  /// Loopback with any valid port: ssh -L may map it to another one. The port does not affect what
  /// a foreign page may do.
  bool is_local() const;
};

WebHost parse_web_host(std::string_view host);

/// True if `origin` is that of the pages served by `host` itself, with or without TLS.
bool is_origin_of(std::string_view origin, std::string_view host, bool tls = false);

}  // namespace hedgehog::base
