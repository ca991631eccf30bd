// SPDX-License-Identifier: MIT
#include "clients/ctl/board/boot_volume.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/regular_file.h"

namespace hedgehog::client {

namespace {

constexpr std::size_t kMaxInfoBytes = 4096;
constexpr const char* kFileName = "/hedgehog.uf2";

bool is_octal(char c) { return c >= '0' && c <= '7'; }

/// "/media/my\040disk" in the kernel's encoding -> "/media/my disk".
std::string unescaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '\\' && i + 3 < text.size() && is_octal(text[i + 1]) &&
                        is_octal(text[i + 2]) && is_octal(text[i + 3]);
    if (!escape) {
      out += text[i];
      continue;
    }
    const int code = (text[i + 1] - '0') * 64 + (text[i + 2] - '0') * 8 + (text[i + 3] - '0');
    out += static_cast<char>(code);
    i += 3;
  }
  return out;
}

bool write_all(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(fd, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool flush(int fd) {
  while (::fsync(fd) != 0)
    if (errno != EINTR) return false;
  return true;
}

}  // namespace

bool is_boot_volume(const std::string& folder) {
  const base::FileText info = base::read_regular_file(folder + "/INFO_UF2.TXT", kMaxInfoBytes);
  if (!info.good()) return false;
  std::istringstream lines(info.text);
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    if (line == "Board-ID: RPI-RP2") return true;
  }
  return false;
}

std::vector<std::string> boot_volumes(std::string_view mounts) {
  std::vector<std::string> volumes;
  std::istringstream lines{std::string(mounts)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string device;
    std::string folder;
    std::string type;
    if (!(fields >> device >> folder >> type)) continue;
    if (type != "vfat" && type != "msdos") continue;
    folder = unescaped(folder);
    if (is_boot_volume(folder)) volumes.push_back(std::move(folder));
  }
  return volumes;
}

std::vector<std::string> mounted_boot_volumes() {
  std::ifstream file("/proc/self/mounts");
  return boot_volumes(std::string{std::istreambuf_iterator<char>(file), {}});
}

std::string copy_to_volume(const std::string& volume, std::string_view content) {
  const std::string path = volume + kFileName;
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (fd < 0) return path + " cannot be written: " + std::strerror(errno);
  std::string why;
  if (!write_all(fd, content)) {
    why = path + " cannot be written: " + std::strerror(errno);
  } else if (!flush(fd)) {
    const int error = errno;
    if (is_boot_volume(volume)) why = path + " cannot be written: " + std::strerror(error);
  }
  ::close(fd);
  return why;
}

}  // namespace hedgehog::client
