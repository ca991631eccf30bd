// SPDX-License-Identifier: MIT
// Daemons that announce themselves on the network as _hedgehog._tcp (DNS-SD), found by Avahi.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clients/lib/address.h"

namespace hedgehog::client {

/// One announcement at one address. Its texts came from the network: control characters and what
/// is not UTF-8 have been replaced.
struct NetworkDaemon {
  std::string name;
  std::string host;
  Address address;
  /// TXT records; nullopt where there is none.
  std::optional<std::string> serial;
  std::optional<std::string> protocol;
};

/// The resolved services in what `avahi-browse --parsable --resolve` printed, one per name and
/// address. Addresses of a link (fe80::/10) are left out where the service has another: they lack
/// their interface.
std::vector<NetworkDaemon> parse_avahi_browse(std::string_view output);

struct NetworkSearch {
  std::vector<NetworkDaemon> daemons;
  /// Why the network could not be searched, for a person; empty: it was.
  std::string failure;
};

/// Runs avahi-browse from the PATH until Avahi has reported all that it knows, a second or two.
NetworkSearch search_network();

}  // namespace hedgehog::client
