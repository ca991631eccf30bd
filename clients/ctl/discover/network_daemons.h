// SPDX-License-Identifier: MIT
// Daemons announced on the network as _hedgehog._tcp (DNS-SD), found by Avahi or, if its programs
// are not installed, by the client library.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clients/lib/discovery/discovered_ball.h"

namespace hedgehog::client {

/// The resolved services in the output of `avahi-browse --parsable --resolve`, one per name and
/// address. Link-local addresses (fe80::/10) are left out if the service has another: they lack
/// their interface.
std::vector<DiscoveredBall> parse_avahi_browse(std::string_view output);

struct NetworkSearch {
  std::vector<DiscoveredBall> daemons;
  /// Why the network could not be searched, for the user; empty: it was searched.
  std::string failure;
};

/// Runs avahi-browse from the PATH until Avahi has reported all known services, a second or two. If
/// it is not installed: `discover` of the library, whose responses a firewall may block.
NetworkSearch search_network();

}  // namespace hedgehog::client
