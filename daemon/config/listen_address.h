// SPDX-License-Identifier: MIT
// Address of a listener.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <boost/system/result.hpp>

namespace hedgehog::config {

struct ListenAddress {
  /// A numeric IPv4 or IPv6 address, the latter in its shortest form and without brackets.
  std::string host;
  /// 0: any free port, printed when bound.
  std::uint16_t port = 0;
  /// TLS and a token are required; always true if other machines can reach the address.
  bool tls = false;
  friend bool operator==(const ListenAddress&, const ListenAddress&) = default;
};

struct AddressError {
  std::string reason;
};

/// "127.0.0.1:7586", "[::1]:7586", "tls://127.0.0.1:7586" or, with TLS either way, "0.0.0.0:7586".
/// The error is a human-readable reason.
boost::system::result<ListenAddress, AddressError> parse_listen_address(std::string_view text);

/// True if the kernel refuses the second of two listeners: of one port, if one of both has the
/// other's address or all addresses of its family. Never with port 0.
bool conflict(const ListenAddress& a, const ListenAddress& b) noexcept;

/// The inverse.
std::string to_string(const ListenAddress& address);

}  // namespace hedgehog::config
