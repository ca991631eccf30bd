// SPDX-License-Identifier: MIT
// Names that a browser sends. Any web page can reach loopback: one of a foreign site is known by
// its `Origin`, one by DNS rebinding by its `Host`. Pure functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hedgehog::base {

/// A `Host` in its parts.
struct WebHost {
  std::string name;  // in small letters, an IPv6 address in its brackets
  std::optional<std::string> port{};

  bool is_v4() const;
  bool is_v6() const;
  /// "localhost", an address 127.x.x.x or "[::1]".
  bool is_loopback() const;
  /// That, with whatever port: ssh -L gives a page another one. What a foreign page may do does not
  /// depend on it.
  bool is_local() const;
};

WebHost parse_web_host(std::string_view host);

/// Whether `origin` is that of the pages that `host` itself serves, with TLS or without.
bool is_origin_of(std::string_view origin, std::string_view host, bool tls = false);

}  // namespace hedgehog::base
