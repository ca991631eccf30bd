// SPDX-License-Identifier: MIT
// Man page (man(7)) of a command line. Pure.
#pragma once

#include <string>

#include "cli/command_tree.h"

namespace hedgehog::cli {

/// `section`: 1, or 8 for administrators' programs. `version`: of the project.
std::string man_page(const Command& program, int section, const std::string& version);

}  // namespace hedgehog::cli
