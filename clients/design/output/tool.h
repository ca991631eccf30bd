// SPDX-License-Identifier: MIT
// Calls of other programs: gnuplot, openscad.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "clients/common/problem.h"

namespace hedgehog::design {

/// Runs argv[0] from the PATH and waits for its end. `package`: its Debian package, for the error
/// if it is missing; if it fails, the error contains the last line of its output.
Result<void> run_tool(const std::vector<std::string>& argv, const std::string& package);

/// A file in the folder for temporary files, deleted with this object.
class TemporaryFile {
 public:
  /// An error (73) if it cannot be created in the folder ($TMPDIR, /tmp).
  static Result<TemporaryFile> make(const std::string& suffix);
  TemporaryFile(TemporaryFile&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();
  const std::string& path() const noexcept { return path_; }

 private:
  explicit TemporaryFile(std::string path) : path_(std::move(path)) {}

  std::string path_;
};

/// An error (73) if the file cannot be written: checked before a long computation. Has no side
/// effects.
Result<void> check_writable(const std::string& path);
/// Writes the whole file; an error (73) with its name if that fails.
Result<void> write_file(const std::string& path, const std::string& content);
/// The whole file, or an error (66).
Result<std::string> read_file(const std::string& path);

}  // namespace hedgehog::design
