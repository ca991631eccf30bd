// SPDX-License-Identifier: MIT
// The trips of a ball as a table of 80 columns, newest first.
#pragma once

#include <string>
#include <vector>

#include "clients/ctl/screen/status_screen.h"
#include "protocol/methods.h"

namespace hedgehog::client {

/// What else is in `history` is left out. Times are those of the reader's clock.
std::vector<std::string> trips_screen(const protocol::HistoryResult& history,
                                      const ScreenStyle& style = {});

}  // namespace hedgehog::client
