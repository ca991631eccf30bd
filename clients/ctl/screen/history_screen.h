// SPDX-License-Identifier: MIT
// `hedgehogctl events --since`: past events, oldest first.
#pragma once

#include <string>
#include <vector>

#include "protocol/methods.h"

namespace hedgehog::client {

/// A line per event, in local time; each day begins with a line of its own.
std::vector<std::string> history_screen(const protocol::HistoryResult& history);

}  // namespace hedgehog::client
