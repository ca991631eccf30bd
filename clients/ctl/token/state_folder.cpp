// SPDX-License-Identifier: MIT
#include "clients/ctl/token/state_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace hedgehog::client {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kFolderMode = 0750;

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

}  // namespace

std::string state_folder(const std::optional<std::string>& given, const Environment& environment,
                         bool root, const std::string& service_folder) {
  if (given) return *given;
  const auto state = environment("XDG_STATE_HOME");
  const std::string own = state && state->starts_with('/')
                              ? *state + "/hedgehog"
                              : environment("HOME").value_or("/tmp") + "/.local/state/hedgehog";
  return is_folder(service_folder) && (root || !is_folder(own)) ? service_folder : own;
}

FolderLock::FolderLock(const std::string& folder) {
  std::error_code ec;
  fs::create_directories(fs::path(folder).parent_path(), ec);
  if (!ec) ::mkdir(folder.c_str(), kFolderMode);
  fd_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd_ < 0 || ::flock(fd_, LOCK_EX) != 0) problem_ = folder + ": " + std::strerror(errno);
}

FolderLock::~FolderLock() {
  if (fd_ >= 0) ::close(fd_);
}

}  // namespace hedgehog::client
