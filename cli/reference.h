// SPDX-License-Identifier: MIT
// A program's man page and completions, written into the folder that an installation copies.
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
/// zsh/site-functions/_<program> and fish/vendor_completions.d/<program>.fish below FOLDER. The
/// exit code (0, or 73 with a sentence on stderr); nullopt: it is another command line.
std::optional<int> write_reference(const CLI::App& app, const std::vector<std::string>& arguments,
                                   int section = 1);

}  // namespace hedgehog::cli
