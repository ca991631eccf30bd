// SPDX-License-Identifier: MIT
// The words of the OpenRPC document.
#pragma once

#include <string_view>

#include "protocol/method.h"

namespace hedgehog::protocol {

std::string_view summary_of(Method method);
/// Empty when the name says it all.
std::string_view meaning_of(std::string_view parameter);

}  // namespace hedgehog::protocol
