// SPDX-License-Identifier: MIT
// Reads whole regular files of bounded size: a FIFO would block until it has a writer, and a device
// may have no end. May block on the disk.
#pragma once

#include <cstddef>
#include <string>

namespace hedgehog::base {

/// Content of a file, or why it was not read.
struct FileText {
  std::string text;
  /// Forms a sentence after the path: "is a FIFO, not a regular file", "is larger than 64 KiB",
  /// "Permission denied". Empty: `text` is the whole file.
  std::string problem;
  /// True if the file does not exist.
  bool missing = false;

  bool good() const noexcept { return problem.empty(); }
};

/// Reads `path`. Follows symbolic links, since users may relocate files, and checks the target.
/// Never waits for a writer and reads only from regular files.
FileText read_regular_file(const std::string& path, std::size_t max_bytes);

/// Why the open file `fd` is not a regular file, worded as `FileText::problem`; empty: regular.
std::string file_problem(int fd);

}  // namespace hedgehog::base
