// SPDX-License-Identifier: MIT
// Everything that /metrics tells, in Prometheus' text format 0.0.4.
#pragma once

#include <string>

#include "daemon/server/server.h"

namespace hedgehog::server {

/// io thread.
std::string metrics_text(Server& server);

}  // namespace hedgehog::server
