// SPDX-License-Identifier: MIT
#include "clients/design/output/tool.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "clients/common/program.h"

namespace hedgehog::design {
namespace {

/// The error message of a program: its last line that is not empty.
std::string last_line(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  return last;
}

Problem cannot_be_written(const std::string& path, int error) {
  return {kCannotCreate, path + " cannot be written: " + std::strerror(error)};
}

}  // namespace

Result<void> run_tool(const std::vector<std::string>& argv, const std::string& package) {
  const auto output = TemporaryFile::make(".txt");
  if (!output) return output.error();
  const client::ProgramEnd end = client::run_program(argv, output->path());
  if (end.succeeded) return {};
  if (end.start_error == ENOENT) {
    return Problem{kUnavailable,
                   argv.front() + " is not installed; on Debian: apt install " + package};
  }
  if (end.start_error != 0)
    return Problem{kUnavailable, argv.front() + ": " + std::strerror(end.start_error)};
  const auto text = read_file(output->path());
  return Problem{kToolFailed,
                 argv.front() + " failed: " + (text ? last_line(*text) : "no message")};
}

Result<TemporaryFile> TemporaryFile::make(const std::string& suffix) {
  std::error_code error;
  const auto folder = std::filesystem::temp_directory_path(error);
  if (error) {
    return Problem{kCannotCreate,
                   "no temporary file can be made, TMPDIR is no folder: " + error.message()};
  }
  std::string path = (folder / ("hedgehog-design-XXXXXX" + suffix)).string();
  const int file = ::mkstemps(path.data(), static_cast<int>(suffix.size()));
  if (file < 0) {
    return Problem{kCannotCreate, "no temporary file can be made in " + folder.string() + ": " +
                                      std::strerror(errno)};
  }
  ::close(file);
  return TemporaryFile(std::move(path));
}

TemporaryFile::~TemporaryFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

Result<void> check_writable(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::path place(path);
  const bool is_there = std::filesystem::exists(place, ignored);
  const std::string folder = place.has_parent_path() ? place.parent_path().string() : ".";
  if (std::filesystem::is_directory(place, ignored)) return cannot_be_written(path, EISDIR);
  if (::faccessat(AT_FDCWD, (is_there ? path : folder).c_str(), W_OK, AT_EACCESS) == 0) return {};
  return cannot_be_written(path, errno);
}

Result<void> write_file(const std::string& path, const std::string& content) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << content;
  file.close();
  return file ? Result<void>() : cannot_be_written(path, errno);
}

Result<std::string> read_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return Problem{kNoInput, path + " is a folder"};
  std::ifstream file(path, std::ios::binary);
  if (!file) return Problem{kNoInput, path + " cannot be read: " + std::strerror(errno)};
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

}  // namespace hedgehog::design
