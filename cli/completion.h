// SPDX-License-Identifier: MIT
// Shell completions of a command line. Pure.
#pragma once

#include <string>

#include "cli/command_tree.h"

namespace hedgehog::cli {

/// A script for bash-completion, or to be sourced.
std::string bash_completion(const Command& program);
/// A function for zsh's $fpath, named _PROGRAM.
std::string zsh_completion(const Command& program);
std::string fish_completion(const Command& program);

}  // namespace hedgehog::cli
