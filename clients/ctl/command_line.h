// SPDX-License-Identifier: MIT
// The command line of hedgehogctl: verbs and their options.
#pragma once

namespace hedgehog::client {

/// Parses, runs the verb, returns the exit code (sysexits.h; only `check` uses 0/1/2/3).
int run_command_line(int argc, char** argv);

}  // namespace hedgehog::client
