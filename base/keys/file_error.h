// SPDX-License-Identifier: MIT
// Errors of a file that people write. All are collected, so that they can be fixed at once.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::keys {

struct FileError {
  /// Path of the file, or command line option ("--listen").
  std::string file;
  /// From 1; 0: no specific line.
  int line = 0;
  /// "limits.current_a"; empty: no specific key.
  std::string key;
  std::string reason;
  friend bool operator==(const FileError&, const FileError&) = default;
};

/// "file:line: key: reason".
std::string to_string(const FileError& error);

/// Never empty when returned as an error.
using FileErrors = std::vector<FileError>;

/// One error per line.
std::string to_string(const FileErrors& errors);

}  // namespace hedgehog::keys
