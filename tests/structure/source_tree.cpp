// SPDX-License-Identifier: MIT
#include "tests/structure/source_tree.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace hedgehog::structure {
namespace {

namespace fs = std::filesystem;

// In a linked worktree of git `.git` is a file.
bool is_skipped(const fs::path& entry) {
  static constexpr std::array<std::string_view, 5> kSkipped{".git", ".cache", ".vscode", ".idea",
                                                            "corpus"};
  const std::string name = entry.filename().string();
  return std::find(kSkipped.begin(), kSkipped.end(), name) != kSkipped.end();
}

bool is_text(const fs::path& file) {
  static constexpr std::array<std::string_view, 6> kBinary{".png", ".jpg", ".gif",
                                                           ".bin", ".rec", ".gz"};
  return std::find(kBinary.begin(), kBinary.end(), file.extension().string()) == kBinary.end();
}

std::vector<std::string> read_lines(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

SourceTree read_tree(const fs::path& root) {
  SourceTree tree;
  for (fs::recursive_directory_iterator it(root), end; it != end; ++it) {
    const std::string path = it->path().lexically_relative(root).generic_string();
    if (it->is_directory()) {
      if (path == "build" || is_skipped(it->path()))
        it.disable_recursion_pending();
      else
        tree.folders.push_back(path);
    } else if (it->is_regular_file() && !is_skipped(it->path())) {
      tree.names.push_back(path);
      if (is_text(it->path())) tree.files.push_back({path, read_lines(it->path())});
    }
  }
  std::sort(tree.folders.begin(), tree.folders.end());
  std::sort(tree.names.begin(), tree.names.end());
  std::sort(tree.files.begin(), tree.files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return tree;
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string{} : path.substr(0, slash);
}

}  // namespace hedgehog::structure
