// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hedgehog::structure {

// One text file of the repository. Path from the root, with '/'.
struct SourceFile {
  std::string path;
  std::vector<std::string> lines;
};

struct SourceTree {
  std::vector<SourceFile> files;     // text files, sorted by path
  std::vector<std::string> folders;  // every folder, sorted
  std::vector<std::string> names;    // every file, pictures included, sorted
};

// Reads the checkout, without build output, version control and editor folders.
SourceTree read_tree(const std::filesystem::path& root);

// "daemon/server" of "daemon/server/router.cpp"; empty at the root.
std::string folder_of(const std::string& path);

}  // namespace hedgehog::structure
