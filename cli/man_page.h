// SPDX-License-Identifier: MIT
// A command line as a page for man (man(7)). Pure.
#pragma once

#include <string>

#include "cli/command_tree.h"

namespace hedgehog::cli {

/// `section`: 1, or 8 for what the administrator runs. `version` is that of the project.
std::string man_page(const Command& program, int section, const std::string& version);

}  // namespace hedgehog::cli
