// SPDX-License-Identifier: MIT
// Addresses at which a daemon may listen, and the order in which a client tries them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/digest_text.h"
#include "clients/lib/client_error.h"

namespace hedgehog::client {

inline constexpr std::uint16_t kDefaultPort = 7586;
/// The daemon's socket in its runtime directory.
inline constexpr std::string_view kSocketName = "hedgehogd.sock";

/// A Unix socket, or a TCP host and port.
struct Address {
  std::string path{};  // not empty: a Unix socket
  std::string host{};
  std::uint16_t port = kDefaultPort;
  bool tls = false;
  /// A ball found by mDNS when a connection is made: `host` is its name or serial number; empty:
  /// the only ball on the network. Implies TLS and a fingerprint.
  bool mdns = false;
  /// With TLS: SHA-256 of the daemon's certificate; nullopt: verified by the system's authorities.
  std::optional<base::Sha256> fingerprint{};
  /// The token that `Connection::open` and `Ball` send in their hello.
  std::optional<std::string> token{};
  friend bool operator==(const Address&, const Address&) = default;
};

/// "/path", "unix:/path", "host", "host:port", "[::1]:port", "tcp:host:port", "tls://host:port",
/// "mdns://", "mdns://NAME".
Outcome<Address> parse_address(std::string_view text);
/// In the format of `parse_address`: "/run/hedgehog/hedgehogd.sock", "127.0.0.1:7586",
/// "[::1]:7586", "tls://192.0.2.7:7586", "mdns://NAME".
std::string to_string(const Address& address);

/// kBadAddress: `address` is an mdns:// address without a fingerprint, and any machine can announce
/// a ball; nullopt: it may be searched for.
std::optional<ClientError> missing_fingerprint(const Address& address);

/// The value of an environment variable; nullopt when it is not set.
using Environment = std::function<std::optional<std::string>(const std::string&)>;
std::optional<std::string> process_environment(const std::string& name);

/// The addresses to try, in order. If `given` (a command-line flag) or else HEDGEHOG_ADDRESS is
/// set, it is the only one. Otherwise: the socket in RUNTIME_DIRECTORY, in /run/hedgehog, in
/// XDG_RUNTIME_DIR/hedgehog (without that variable: /tmp/hedgehog-UID), and 127.0.0.1:7586. Each
/// has the token of HEDGEHOG_TOKEN, and with TLS the fingerprint of HEDGEHOG_FINGERPRINT. "mdns://"
/// is resolved later, when a connection is made.
Outcome<std::vector<Address>> daemon_addresses(
    const std::optional<std::string>& given = std::nullopt,
    const Environment& environment = process_environment);

}  // namespace hedgehog::client
