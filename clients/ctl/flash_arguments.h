// SPDX-License-Identifier: MIT
// The command line of `board flash`.
#pragma once

#include "clients/ctl/board/flash_verb.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
}

namespace hedgehog::client {

void add_flash_arguments(CLI::App& command, FlashOptions& options);

}  // namespace hedgehog::client
