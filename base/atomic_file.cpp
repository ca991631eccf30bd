// SPDX-License-Identifier: MIT
#include "base/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace hedgehog::base {

std::string write_file_atomically(const std::string& path, std::string_view content, mode_t mode) {
  const std::string fresh = path + ".new";
  // Removes a leftover of any type first: opening a FIFO of that name would block until it has a
  // reader.
  if (::unlink(fresh.c_str()) != 0 && errno != ENOENT) return fresh + ": " + std::strerror(errno);
  const int fd = ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (fd < 0) return fresh + ": " + std::strerror(errno);
  bool good = true;
  while (good && !content.empty()) {
    const ssize_t written = ::write(fd, content.data(), content.size());
    good = written > 0 || (written < 0 && errno == EINTR);
    content.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
  good = good && ::fsync(fd) == 0;
  const int error = errno;
  ::close(fd);
  if (!good) {
    ::unlink(fresh.c_str());
    return fresh + ": " + std::strerror(error);
  }
  if (std::rename(fresh.c_str(), path.c_str()) != 0) {
    std::string problem = path + ": " + std::strerror(errno);
    ::unlink(fresh.c_str());
    return problem;
  }
  return sync_folder(std::filesystem::path(path).parent_path());
}

std::string sync_folder(const std::string& folder) {
  const int at = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (at < 0) return folder + ": " + std::strerror(errno);
  // EINVAL: the file system does not support syncing a directory.
  const int error = ::fsync(at) == 0 || errno == EINVAL ? 0 : errno;
  ::close(at);
  return error == 0 ? std::string() : folder + ": " + std::strerror(error);
}

}  // namespace hedgehog::base
