// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "daemon/config/json_text.h"
#include "daemon/config/load_config.h"

namespace hedgehog::config {
namespace {

boost::system::error_code system_error(int code) {
  return {code, boost::system::system_category()};
}

class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

}  // namespace

boost::system::result<std::string> read_file(const std::string& path) {
  const Descriptor file(path);
  if (file.get() < 0) return system_error(errno);
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return system_error(errno);
  if (S_ISDIR(info.st_mode)) return system_error(EISDIR);
  std::string text;
  std::array<char, 65536> block{};
  while (text.size() <= kMaxFileBytes) {
    const ssize_t got = ::read(file.get(), block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return system_error(errno);
    if (got == 0) return text;
    text.append(block.data(), static_cast<std::size_t>(got));
  }
  return system_error(EFBIG);
}

}  // namespace hedgehog::config
