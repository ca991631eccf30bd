// SPDX-License-Identifier: MIT
// The command line of `board flash`.
#pragma once

#include "cli/program.h"
#include "clients/ctl/board/flash_verb.h"

namespace hedgehog::client {

void add_flash_arguments(const cli::CommandSpec& command, FlashOptions& options);

}  // namespace hedgehog::client
