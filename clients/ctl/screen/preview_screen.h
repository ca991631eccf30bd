// SPDX-License-Identifier: MIT
// Preview of an effect, as lines of 80 columns.
#pragma once

#include <string>
#include <vector>

#include "protocol/methods.h"

namespace hedgehog::client {

/// `what`: "pulse left". The current of each winding over time, all three on one scale.
std::vector<std::string> preview_screen(const std::string& what,
                                        const protocol::PreviewResult& preview, bool ascii);

}  // namespace hedgehog::client
