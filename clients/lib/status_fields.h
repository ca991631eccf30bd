// SPDX-License-Identifier: MIT
// Fields of the status by name, as given by a user.
#pragma once

#include <string>
#include <vector>

#include "clients/lib/client_error.h"
#include "protocol/values/status_keys.h"

namespace hedgehog::client {

/// The keys of `names`; without names the default of telemetry. kBadAddress: "fields: the status
/// has no 'warmth'".
Outcome<protocol::StatusKeys> status_fields(const std::vector<std::string>& names);

}  // namespace hedgehog::client
