// SPDX-License-Identifier: MIT
// Another program that is asked for help, such as gnuplot.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::client {

struct ProgramEnd {
  int start_error = 0;  // an errno: it did not run
  bool succeeded = false;
};

/// Runs argv[0] from the PATH in `folder`, without input, and waits for its end. What it prints
/// replaces what the file `output` has, whose path may begin in `folder`.
ProgramEnd run_program(std::vector<std::string> argv, const std::string& output,
                       const std::string& folder = ".");

}  // namespace hedgehog::client
