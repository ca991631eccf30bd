// SPDX-License-Identifier: MIT
#include "clients/common/arguments.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "cli/complaint.h"
#include "cli/reference.h"
#include "clients/common/ascii_output.h"
#include "clients/common/exit_code.h"

namespace hedgehog::client {

std::optional<int> parse_arguments(CLI::App& app, int argc, const char* const* argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (const auto code = cli::write_reference(app, arguments)) return code;
  print_as_the_locale_allows(arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "%s\n", cli::usage_error(app, cli::complaint(app, error)).c_str());
    return kUsage;
  }
  return std::nullopt;
}

}  // namespace hedgehog::client
