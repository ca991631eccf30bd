// SPDX-License-Identifier: MIT
// The command line of `calibrate`.
#pragma once

#include "cli/program.h"
#include "clients/ctl/calibrate/calibrate_verb.h"

namespace hedgehog::client {

void add_calibrate_arguments(const cli::CommandSpec& command, CalibrateOptions& options);

}  // namespace hedgehog::client
