// SPDX-License-Identifier: MIT
// The ball that an address that begins with mdns:// means.
#pragma once

#include <string_view>
#include <vector>

#include "clients/lib/client_error.h"
#include "clients/lib/discovery/discovered_ball.h"

namespace hedgehog::client {

/// Those of that name, else those of that serial number; only with TLS, without it nothing is
/// connected to.
std::vector<DiscoveredBall> named_balls(std::string_view name,
                                        const std::vector<DiscoveredBall>& balls);

/// The one of `balls` that is meant, at each of its addresses. `name`: its name or serial number;
/// empty: there is only one. kNoDaemon: there is none, or more than one; the message lists them.
Outcome<std::vector<DiscoveredBall>> chosen_ball(std::string_view name,
                                                 const std::vector<DiscoveredBall>& balls);

}  // namespace hedgehog::client
