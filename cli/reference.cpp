// SPDX-License-Identifier: MIT
#include "cli/reference.h"

#include <sysexits.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "cli/command_tree.h"
#include "cli/completion.h"
#include "cli/man_page.h"

namespace hedgehog::cli {

namespace {

bool write(const std::filesystem::path& path, const std::string& text) {
  std::error_code failed;
  std::filesystem::create_directories(path.parent_path(), failed);
  std::ofstream file(path);
  file << text;
  file.close();
  if (file) return true;
  std::fprintf(stderr, "%s: cannot be written\n", path.c_str());
  return false;
}

}  // namespace

std::optional<int> write_reference(const CLI::App& app, const std::vector<std::string>& arguments,
                                   int section) {
  if (arguments.size() != 2 || arguments[0] != "--reference") return std::nullopt;
  const std::filesystem::path folder = arguments[1];
  const Command program = command_tree(app);
  const std::string& name = program.name;
  const std::string number = std::to_string(section);
  const bool written =
      write(folder / "man" / ("man" + number) / (name + "." + number),
            man_page(program, section, HEDGEHOG_VERSION)) &&
      write(folder / "bash-completion/completions" / name, bash_completion(program)) &&
      write(folder / "zsh/site-functions" / ("_" + name), zsh_completion(program)) &&
      write(folder / "fish/vendor_completions.d" / (name + ".fish"), fish_completion(program));
  return written ? EX_OK : EX_CANTCREAT;
}

}  // namespace hedgehog::cli
