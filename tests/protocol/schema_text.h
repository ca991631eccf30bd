// SPDX-License-Identifier: MIT
// The descriptions of the OpenRPC document.
#pragma once

#include <string_view>

#include "protocol/wire/error.h"

namespace hedgehog::protocol {

/// Empty when the name is self-explanatory.
std::string_view meaning_of(std::string_view parameter);
std::string_view meaning_of(ErrorCode code);

}  // namespace hedgehog::protocol
