// SPDX-License-Identifier: MIT
// The words of the OpenRPC document.
#pragma once

#include <string_view>

namespace hedgehog::protocol {

/// Empty when the name says it all.
std::string_view meaning_of(std::string_view parameter);

}  // namespace hedgehog::protocol
