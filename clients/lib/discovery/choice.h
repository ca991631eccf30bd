// SPDX-License-Identifier: MIT
// Selection of the ball that an mdns:// address refers to.
#pragma once

#include <string_view>
#include <vector>

#include "clients/lib/client_error.h"
#include "clients/lib/discovery/discovered_ball.h"

namespace hedgehog::client {

/// Those of that name, else those of that serial number; only with TLS, which a connection
/// requires.
std::vector<DiscoveredBall> named_balls(std::string_view name,
                                        const std::vector<DiscoveredBall>& balls);

/// The matching ball, at each of its addresses. `name`: its name or serial number; empty: the only
/// ball. kNoDaemon: none or more than one matches; the message lists them.
Outcome<std::vector<DiscoveredBall>> chosen_ball(std::string_view name,
                                                 const std::vector<DiscoveredBall>& balls);

}  // namespace hedgehog::client
