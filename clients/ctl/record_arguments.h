// SPDX-License-Identifier: MIT
// The options of `hedgehogctl record`.
#pragma once

#include "cli/program.h"
#include "clients/ctl/verbs/record_verb.h"

namespace hedgehog::client {

/// Values are stored in `options`, which must outlive `command`.
void add_record_arguments(const cli::CommandSpec& command, RecordOptions& options);

}  // namespace hedgehog::client
