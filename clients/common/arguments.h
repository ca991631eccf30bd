// SPDX-License-Identifier: MIT
// The command line of a program.
#pragma once

#include <optional>

#include "cli/program.h"

namespace hedgehog::client {

/// Parses the command line into `program`; from here on ASCII is printed where the locale is not
/// UTF-8. The exit code if the program ends with that: after --help, --version, --reference, and
/// (64) after a usage error.
std::optional<int> parse_arguments(cli::Program& program, int argc, const char* const* argv);

}  // namespace hedgehog::client
