// SPDX-License-Identifier: MIT
// A ball that has announced itself on the network.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "clients/lib/address.h"

namespace hedgehog::client {

/// One announcement at one address. Its texts come from the network: control characters and invalid
/// UTF-8 have been replaced.
struct DiscoveredBall {
  std::string name;
  std::string host;
  /// Numeric, with its port. `tls` is what is announced; the daemon always announces it.
  Address address;
  /// TXT records; nullopt: missing.
  std::optional<std::string> serial;
  std::optional<std::string> protocol;
  friend bool operator==(const DiscoveredBall&, const DiscoveredBall&) = default;
};

/// `text`, which any machine of the network may have sent, without terminal control sequences: "?"
/// for control characters (C0, C1, DEL), U+FFFD for invalid UTF-8.
std::string printable(std::string_view text);

}  // namespace hedgehog::client
