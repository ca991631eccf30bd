// SPDX-License-Identifier: MIT
// The counters with known labels, at 0: a rate would not include the first event of a new counter.
#pragma once

#include "daemon/server/session/counters.h"

namespace hedgehog::server {

/// io thread only.
Counters known_counters();

}  // namespace hedgehog::server
