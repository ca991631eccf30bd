// SPDX-License-Identifier: MIT
// A time in the past as typed on a command line.
#pragma once

#include <cstdint>
#include <string>

#include "clients/lib/client_error.h"

namespace hedgehog::client {

/// RFC 3339 of "today" or "yesterday" (from midnight on), of a time span before now ("90s",
/// "30min", "2h", "3d"), of a local time or date ("23:14": its last occurrence, "2026-11-20",
/// "2026-11-20 23:14", either with seconds), or of RFC 3339 itself. `now_ms` is since 1970.
Outcome<std::string> since_rfc3339(const std::string& text, std::int64_t now_ms);

}  // namespace hedgehog::client
