// SPDX-License-Identifier: MIT
#include "base/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace hedgehog::base {
namespace {

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a FIFO";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

std::string size_text(std::size_t bytes) {
  constexpr std::size_t kKiB = 1024;
  if (bytes == 0 || bytes % kKiB != 0) return std::to_string(bytes) + " bytes";
  if (bytes % (kKiB * kKiB) != 0) return std::to_string(bytes / kKiB) + " KiB";
  return std::to_string(bytes / kKiB / kKiB) + " MiB";
}

FileText failed(std::string problem, int error = 0) {
  return {{}, std::move(problem), error == ENOENT || error == ENOTDIR};
}

/// Reads `fd` to its end; its size may change meanwhile.
FileText read_to_end(int fd, std::size_t reported_bytes, std::size_t max_bytes) {
  constexpr std::size_t kBlock = 65536;
  FileText file;
  std::size_t got = 0;
  for (;;) {
    file.text.resize(std::min(max_bytes + 1, std::max(reported_bytes + 1, got + kBlock)));
    const ssize_t count = ::read(fd, file.text.data() + got, file.text.size() - got);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failed(std::strerror(errno));
    if (count == 0) break;
    got += static_cast<std::size_t>(count);
    if (got > max_bytes) return failed("is larger than " + size_text(max_bytes));
  }
  file.text.resize(got);
  return file;
}

}  // namespace

std::string file_problem(int fd) {
  struct stat info {};
  if (::fstat(fd, &info) != 0) return std::strerror(errno);
  if (S_ISREG(info.st_mode)) return {};
  return std::string("is ") + kind_of(info.st_mode) + ", not a regular file";
}

FileText read_regular_file(const std::string& path, std::size_t max_bytes) {
  // O_NONBLOCK: opening a FIFO does not block. O_NOCTTY: no controlling terminal is acquired.
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (fd < 0) return failed(std::strerror(errno), errno);
  FileText file;
  file.problem = file_problem(fd);
  struct stat info {};
  if (file.good() && ::fstat(fd, &info) == 0) {
    const auto bytes = static_cast<std::size_t>(std::max<off_t>(0, info.st_size));
    file = bytes > max_bytes ? failed("is larger than " + size_text(max_bytes))
                             : read_to_end(fd, bytes, max_bytes);
  }
  ::close(fd);
  return file;
}

}  // namespace hedgehog::base
