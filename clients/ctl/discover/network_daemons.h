// SPDX-License-Identifier: MIT
// Daemons that announce themselves on the network as _hedgehog._tcp (DNS-SD), found by Avahi or,
// where its programs are not installed, by the client library.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clients/lib/discovery/discovered_ball.h"

namespace hedgehog::client {

/// The resolved services in what `avahi-browse --parsable --resolve` printed, one per name and
/// address. Addresses of a link (fe80::/10) are left out where the service has another: they lack
/// their interface.
std::vector<DiscoveredBall> parse_avahi_browse(std::string_view output);

struct NetworkSearch {
  std::vector<DiscoveredBall> daemons;
  /// Why the network could not be searched, for a person; empty: it was.
  std::string failure;
};

/// Runs avahi-browse from the PATH until Avahi has reported all that it knows, a second or two.
/// Where there is none, `discover` of the library, whose answers a firewall may keep out.
NetworkSearch search_network();

}  // namespace hedgehog::client
