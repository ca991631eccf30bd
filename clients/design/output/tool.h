// SPDX-License-Identifier: MIT
// Other programs that are asked for help: gnuplot, openscad.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "clients/common/problem.h"

namespace hedgehog::design {

/// Runs argv[0] from the PATH and waits for its end. `package`: the Debian package that has it, for
/// the complaint when it is missing; when it fails, the complaint holds the last line it said.
Result<void> run_tool(const std::vector<std::string>& argv, const std::string& package);

/// A file of its own in the folder for temporary files, gone with this object.
class TemporaryFile {
 public:
  /// Complains (73) when the folder ($TMPDIR, /tmp) takes none.
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

/// Complains (73) when no file can be written there: for what is asked before long work. Touches
/// nothing.
Result<void> check_writable(const std::string& path);
/// Writes the whole file, or complains (73) and names it.
Result<void> write_file(const std::string& path, const std::string& content);
/// The whole file, or a complaint (66).
Result<std::string> read_file(const std::string& path);

}  // namespace hedgehog::design
