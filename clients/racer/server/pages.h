// SPDX-License-Identifier: MIT
// The page's files, all of them in memory: what was not in the folder at the start cannot be asked
// for, by whatever path.
#pragma once

#include <map>
#include <string>

namespace hedgehog::racer {

struct PageFile {
  std::string type;
  std::string bytes;
};

class Pages {
 public:
  /// Reads the regular files of known types in `folder`, 16 MB at most. A folder without index.html
  /// has none: "/" then says so in words, and how the page is built.
  explicit Pages(const std::string& folder);

  /// "/" is "/index.html". nullptr: there is no such file.
  const PageFile* find(const std::string& path) const;

  /// `share/hedgehog/racer` of the prefix that this program stands in: one folder below it (bin),
  /// or two (clients/racer of a build).
  static std::string default_folder();

 private:
  std::map<std::string, PageFile> files_;
};

}  // namespace hedgehog::racer
