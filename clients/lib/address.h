// SPDX-License-Identifier: MIT
// Where a daemon may listen, and where to look for it.
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
  /// A ball that is searched for on the network when a connection is made: `host` is its name or
  /// serial number, empty: the only one there. Has TLS and a fingerprint.
  bool mdns = false;
  /// With TLS, of the daemon's certificate; nullopt: the system's authorities vouch for it.
  std::optional<base::Sha256> fingerprint{};
  /// What `Connection::open` and `Ball` introduce themselves with.
  std::optional<std::string> token{};
  friend bool operator==(const Address&, const Address&) = default;
};

/// "/path", "unix:/path", "host", "host:port", "[::1]:port", "tcp:host:port", "tls://host:port",
/// "mdns://", "mdns://NAME".
Outcome<Address> parse_address(std::string_view text);
/// As `parse_address` reads it: "/run/hedgehog/hedgehogd.sock", "127.0.0.1:7586", "[::1]:7586",
/// "tls://192.0.2.7:7586", "mdns://NAME".
std::string to_string(const Address& address);

/// kBadAddress: `address` is one of mdns:// without a fingerprint, and any machine can announce a
/// ball; nullopt: it may be searched for.
std::optional<ClientError> missing_fingerprint(const Address& address);

/// The value of an environment variable; nullopt when it is not set.
using Environment = std::function<std::optional<std::string>(const std::string&)>;
std::optional<std::string> process_environment(const std::string& name);

/// The places to try, in order. `given` (a command-line flag) or else HEDGEHOG_ADDRESS is the only
/// one when there is one. Otherwise: the socket in RUNTIME_DIRECTORY, in /run/hedgehog, in
/// XDG_RUNTIME_DIR/hedgehog (without that variable: /tmp/hedgehog-UID), and 127.0.0.1:7586. Each
/// has the token of HEDGEHOG_TOKEN, and with TLS the fingerprint of HEDGEHOG_FINGERPRINT. Only
/// "mdns://" searches the network, later.
Outcome<std::vector<Address>> daemon_addresses(
    const std::optional<std::string>& given = std::nullopt,
    const Environment& environment = process_environment);

}  // namespace hedgehog::client
