// SPDX-License-Identifier: MIT
// Initialises the counters with known labels to 0: the rate of a counter that appears with its
// first event would not include that event.
#pragma once

#include "daemon/server/session/counters.h"

namespace hedgehog::server {

/// io thread only.
Counters known_counters();

}  // namespace hedgehog::server
