// SPDX-License-Identifier: MIT
// The trips of a ball as a table of 80 columns, newest first.
#pragma once

#include <string>
#include <vector>

#include "clients/ctl/screen/status_screen.h"
#include "protocol/methods.h"

namespace hedgehog::client {

/// Other events in `history` are left out. Times are local.
std::vector<std::string> trips_screen(const protocol::HistoryResult& history,
                                      const ScreenStyle& style = {});

}  // namespace hedgehog::client
