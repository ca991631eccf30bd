// SPDX-License-Identifier: MIT
// A folder that is removed at the end of the test.
#pragma once

#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace hedgehog {

/// In memory if enough is free, so that no slow disk delays a test; TMPDIR has precedence.
inline std::filesystem::path temporary_place() {
  constexpr std::uintmax_t kMinFree = std::uintmax_t{512} << 20;
  const char* const memory = "/dev/shm";
  struct statvfs there {};
  const bool fits = std::getenv("TMPDIR") == nullptr && ::statvfs(memory, &there) == 0 &&
                    (there.f_flag & ST_NOEXEC) == 0 &&
                    there.f_bavail * there.f_frsize >= kMinFree && ::access(memory, W_OK) == 0;
  return fits ? std::filesystem::path(memory) : std::filesystem::temp_directory_path();
}

class TemporaryFolder {
 public:
  /// Creates an empty folder below `place`. Throws std::system_error.
  explicit TemporaryFolder(const std::filesystem::path& place = temporary_place()) {
    path_ = (place / "hedgehog-test-XXXXXX").string();
    if (::mkdtemp(path_.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(), path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::string& path() const noexcept { return path_; }
  /// The path of `below` in the folder.
  std::string path(const std::string& below) const { return path_ + "/" + below; }
  /// Empty when there is no such file.
  std::string read(const std::string& below) const {
    std::ifstream file(path(below), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// Creates missing parent folders. Returns the path.
  std::string write(const std::string& below, const std::string& text) const {
    std::string file_path = path(below);
    std::filesystem::create_directories(std::filesystem::path(file_path).parent_path());
    std::ofstream(file_path, std::ios::binary) << text;
    return file_path;
  }

 private:
  std::string path_;
};

}  // namespace hedgehog
