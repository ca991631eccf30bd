// SPDX-License-Identifier: MIT
// Identifier of one start of the daemon.
#pragma once

#include <string>

namespace hedgehog::server {

/// Sixteen hexadecimal digits from the system's random numbers: a client that gets others after a
/// lost connection is connected to another daemon, or to another start of the same.
std::string random_start_id();

}  // namespace hedgehog::server
