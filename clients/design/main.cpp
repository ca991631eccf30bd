// SPDX-License-Identifier: MIT
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "clients/common/ascii_output.h"
#include "clients/common/exit_code.h"
#include "clients/design/command_line.h"

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    hedgehog::client::print_as_the_locale_allows(arguments);
    return hedgehog::design::run_command_line(arguments, std::cout, std::cerr);
  } catch (const std::exception& error) {
    std::cerr << "hedgehog-design: " << error.what() << "\n";
    return hedgehog::kInternal;
  }
}
