// SPDX-License-Identifier: MIT
// The command line of a program, and its usage errors.
#pragma once

#include <optional>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
}

namespace hedgehog::client {

/// Reads the command line into `app`. The exit code when the program ends with that: after --help,
/// --version, and (64) what CLI11 complains of.
std::optional<int> parse_arguments(CLI::App& app, int argc, const char* const* argv);

/// "hedgehogctl pulse: <what>; hedgehogctl pulse --help says more", with the verb that was given.
std::string usage_error(const CLI::App& app, const std::string& what);

}  // namespace hedgehog::client
