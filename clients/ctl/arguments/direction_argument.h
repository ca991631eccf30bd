// SPDX-License-Identifier: MIT
// A direction as typed on a command line.
#pragma once

#include <string>

#include "clients/lib/client_error.h"

namespace hedgehog::client {

/// The protocol's JSON for a word ("left"), a pin ("34"), azimuth and elevation in degrees
/// ("90,20") or a vector ("0,1,0.5"). Words are passed unchanged: the daemon validates them, and
/// its error lists the valid ones.
Outcome<std::string> direction_json(const std::string& text);

}  // namespace hedgehog::client
