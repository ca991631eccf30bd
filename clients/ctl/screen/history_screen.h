// SPDX-License-Identifier: MIT
// `hedgehogctl events --since`: what has happened, oldest first.
#pragma once

#include <string>
#include <vector>

#include "protocol/methods.h"

namespace hedgehog::client {

/// A line an event, at the time of day of this place; each day begins with a line of its own.
std::vector<std::string> history_screen(const protocol::HistoryResult& history);

}  // namespace hedgehog::client
