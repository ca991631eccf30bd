// SPDX-License-Identifier: MIT
// Whole files into memory, when they are regular and of a bounded size: a FIFO would wait for its
// writer, and a device never end. May wait for the disk.
#pragma once

#include <cstddef>
#include <string>

namespace hedgehog::base {

/// What a file has, or why it was not read.
struct FileText {
  std::string text;
  /// Behind the path it makes a sentence: "is a FIFO, not a regular file", "is larger than 64 KiB",
  /// "Permission denied". Empty: `text` is the whole file.
  std::string problem;
  /// There is no file of that name.
  bool missing = false;

  bool good() const noexcept { return problem.empty(); }
};

/// Reads `path`; symbolic links are followed, since people move what they keep, and what is behind
/// them counts. Never waits for a writer and never reads from anything but a regular file.
FileText read_regular_file(const std::string& path, std::size_t max_bytes);

/// Why the open file `fd` is no regular file, as `FileText::problem`; empty: it is one.
std::string why_not_regular(int fd);

}  // namespace hedgehog::base
