// SPDX-License-Identifier: MIT
// Fields of the status by their names, as a person gives them.
#pragma once

#include <string>
#include <vector>

#include "clients/lib/client_error.h"
#include "protocol/values/status_keys.h"

namespace hedgehog::client {

/// The keys of `names`; none: what telemetry has by default. kBadAddress: "fields: the status has
/// no 'warmth'".
Outcome<protocol::StatusKeys> status_fields(const std::vector<std::string>& names);

}  // namespace hedgehog::client
