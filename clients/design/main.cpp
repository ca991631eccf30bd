// SPDX-License-Identifier: MIT
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "clients/common/exit_code.h"
#include "clients/design/command_line.h"

int main(int argc, char** argv) {
  try {
    return hedgehog::design::run_command_line({argv + 1, argv + argc}, std::cout, std::cerr);
  } catch (const std::exception& error) {
    std::cerr << "hedgehog-design: " << error.what() << "\n";
    return hedgehog::kInternal;
  }
}
