// SPDX-License-Identifier: MIT
// Response timeout of a client.
#pragma once

#include <chrono>

#include "clients/lib/address.h"

namespace hedgehog::client {

/// 2 s, or HEDGEHOG_PATIENCE_MS of `environment`: an integer of 100 to 600000, anything else is
/// ignored.
std::chrono::milliseconds response_timeout(const Environment& environment);
/// The same of this process, whose environment is read once. Any thread.
std::chrono::milliseconds response_timeout();

}  // namespace hedgehog::client
