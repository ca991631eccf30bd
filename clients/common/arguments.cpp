// SPDX-License-Identifier: MIT
#include "clients/common/arguments.h"

#include <string>
#include <vector>

#include "clients/common/ascii_output.h"

namespace hedgehog::client {

std::optional<int> parse_arguments(cli::Program& program, int argc, const char* const* argv) {
  print_as_the_locale_allows(std::vector<std::string>(argv + 1, argv + argc));
  return program.parse_and_print(argc, argv);
}

}  // namespace hedgehog::client
