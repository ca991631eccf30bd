// SPDX-License-Identifier: MIT
// Identifier of one start of the daemon.
#pragma once

#include <string>

namespace hedgehog::server {

/// Sixteen random hexadecimal digits; others after a lost connection: another start or daemon.
std::string random_start_id();

}  // namespace hedgehog::server
