// SPDX-License-Identifier: MIT
// The metrics of /metrics, in Prometheus' text format 0.0.4.
#pragma once

#include <string>

#include "daemon/server/rpc/server.h"

namespace hedgehog::server {

/// io thread.
std::string metrics_text(Server& server);

}  // namespace hedgehog::server
