// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>

#include "clients/common/exit_code.h"
#include "clients/ctl/command_line.h"

int main(int argc, char** argv) {
  try {
    return hedgehog::client::run_command_line(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hedgehogctl: %s\n", error.what());
    return hedgehog::kInternal;
  }
}
