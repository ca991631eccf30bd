// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace hedgehog::design {

/// hedgehog-design with these arguments (without the program's own name); returns its exit code.
/// Answers go to `out`, complaints and progress to `err`.
int run_command_line(std::vector<std::string> arguments, std::ostream& out, std::ostream& err);

}  // namespace hedgehog::design
