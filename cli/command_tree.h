// SPDX-License-Identifier: MIT
// A command line as plain values: verbs, arguments, options.
#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
}

namespace hedgehog::cli {

struct CommandOption {
  /// "-f", "--follow"; for a positional argument its name.
  std::vector<std::string> names{};
  /// Placeholder of its value, "FILE" or "1..10000"; empty: no value.
  std::string value{};
  /// All allowed values; empty: not a fixed set.
  std::vector<std::string> choices{};
  std::string help{};
  /// The environment variable that sets it; empty: none.
  std::string environment{};
  /// Default value; empty: none, or not known.
  std::string fallback{};
  bool required = false;
};

struct Command {
  std::string name{};
  std::string help{};
  std::string footer{};
  std::vector<CommandOption> arguments{};
  std::vector<CommandOption> options{};
  std::vector<Command> verbs{};
  bool needs_verb = false;
  /// True if its options are also accepted after its verbs.
  bool options_behind_verbs = false;
};

/// Without entries hidden from --help.
Command command_tree(const CLI::App& app);

}  // namespace hedgehog::cli
