// SPDX-License-Identifier: MIT
// A ball that has announced itself on the network.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "clients/lib/address.h"

namespace hedgehog::client {

/// One announcement at one address. Its texts came from the network: control characters and what
/// is not UTF-8 have been replaced.
struct DiscoveredBall {
  std::string name;
  std::string host;
  /// In digits, with its port. `tls` is what it announces; the daemon always does.
  Address address;
  /// TXT records; nullopt where there is none.
  std::optional<std::string> serial;
  std::optional<std::string> protocol;
  friend bool operator==(const DiscoveredBall&, const DiscoveredBall&) = default;
};

/// `text`, which any machine of the network may have written: nothing that moves a terminal's
/// cursor, "?" for control characters (C0, C1, DEL), U+FFFD for what is not UTF-8.
std::string printable(std::string_view text);

}  // namespace hedgehog::client
