// SPDX-License-Identifier: MIT
#include <sysexits.h>

#include <cstdio>
#include <exception>

#include "clients/study/command_line.h"

int main(int argc, char** argv) {
  try {
    return hedgehog::study::run_command_line(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hedgehog-study: %s\n", error.what());
    return EX_SOFTWARE;
  }
}
