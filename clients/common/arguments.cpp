// SPDX-License-Identifier: MIT
#include "clients/common/arguments.h"

#include <CLI/CLI.hpp>

#include "clients/common/exit_code.h"

namespace hedgehog::client {

std::optional<int> parse_arguments(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return kUsage;
  }
  return std::nullopt;
}

std::string usage_error(const CLI::App& app, const std::string& what) {
  const auto verbs = app.get_subcommands();
  const std::string name = app.get_name() + (verbs.empty() ? "" : " " + verbs.front()->get_name());
  return name + ": " + what + "; " + name + " --help says more";
}

}  // namespace hedgehog::client
