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
  /// "-f", "--follow"; of a positional argument its name.
  std::vector<std::string> names{};
  /// What its value looks like, "FILE" or "1..10000"; empty: it takes none.
  std::string value{};
  /// All that may be given; empty: not a fixed set.
  std::vector<std::string> choices{};
  std::string help{};
  /// The environment variable that stands for it; empty: none.
  std::string environment{};
  /// Used when it is not given; empty: nothing, or not known.
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
  /// Its options may stand behind its verbs too.
  bool options_behind_verbs = false;
};

/// Without what --help hides.
Command command_tree(const CLI::App& app);

}  // namespace hedgehog::cli
