// SPDX-License-Identifier: MIT
// The command line of hedgehogctl: which verb, and what it was told.
#pragma once

namespace hedgehog::client {

/// Parses, runs the verb, returns the exit code (sysexits.h; `check` alone speaks 0/1/2/3).
int run_command_line(int argc, char** argv);

}  // namespace hedgehog::client
