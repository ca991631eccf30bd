// SPDX-License-Identifier: MIT
// The balls that `hedgehogctl discover` found, as a table of 80 columns or as JSON.
#pragma once

#include <string>
#include <vector>

#include "clients/ctl/discover/discovery.h"
#include "clients/ctl/screen/status_screen.h"

namespace hedgehog::client {

/// One line per ball and address: those of this machine first. The address comes last and is never
/// cut, so that it can be copied.
std::vector<std::string> discovery_screen(const Discovery& discovery,
                                          const ScreenStyle& style = {});

/// {"local":[{"instance","address","name","model","simulated","state","protocol","serial"}, or with
/// "failure" instead of all from "name" on],"network":[{"name","host","address","serial",
/// "protocol","tls"}],"network_failure":null or why the network was not searched}.
std::string discovery_json(const Discovery& discovery);

}  // namespace hedgehog::client
