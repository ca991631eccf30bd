// SPDX-License-Identifier: MIT
// The counters whose labels are known from the start, at 0: the rate of a counter that appears with
// its first event does not show that event.
#pragma once

#include "daemon/server/session/counters.h"

namespace hedgehog::server {

/// io thread only.
Counters known_counters();

}  // namespace hedgehog::server
