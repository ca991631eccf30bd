// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace hedgehog::design {

/// Runs hedgehog-design with these arguments (without the program's own name); returns its exit
/// code. Results are written to `out`, errors and progress to `err`.
int run_command_line(const std::vector<std::string>& arguments, std::ostream& out,
                     std::ostream& err);

}  // namespace hedgehog::design
