// SPDX-License-Identifier: MIT
// Writes a program's man page and completions into the folder copied by the installation.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
}

namespace hedgehog::cli {

/// When `arguments`, without the program's name, are `--reference FOLDER`: writes
/// man/man<section>/<program>.<section>, bash-completion/completions/<program>,
/// zsh/site-functions/_<program> and fish/vendor_completions.d/<program>.fish below FOLDER. Returns
/// the exit code (0, or 73 with a message on stderr); nullopt: another command line.
std::optional<int> write_reference(const CLI::App& app, const std::vector<std::string>& arguments,
                                   int section = 1);

}  // namespace hedgehog::cli
