// SPDX-License-Identifier: MIT
// A command line as completions for shells. Pure.
#pragma once

#include <string>

#include "cli/command_tree.h"

namespace hedgehog::cli {

/// A script that bash-completion loads, or that is sourced.
std::string bash_completion(const Command& program);
/// A function for zsh's $fpath, named _PROGRAM.
std::string zsh_completion(const Command& program);
std::string fish_completion(const Command& program);

}  // namespace hedgehog::cli
