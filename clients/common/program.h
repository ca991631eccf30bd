// SPDX-License-Identifier: MIT
// Child processes of other programs, such as gnuplot.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::client {

struct ProgramEnd {
  int start_error = 0;  // an errno: it could not be started
  bool succeeded = false;
};

/// Runs argv[0] from the PATH in `folder`, without input, and waits for its end. Its output
/// replaces the content of the file `output`, whose path may be relative to `folder`.
ProgramEnd run_program(std::vector<std::string> argv, const std::string& output,
                       const std::string& folder = ".");

}  // namespace hedgehog::client
