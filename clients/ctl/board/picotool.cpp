// SPDX-License-Identifier: MIT
#include "clients/ctl/board/picotool.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "clients/common/program.h"

namespace hedgehog::client {

namespace {

std::string last_line(const std::string& path) {
  std::ifstream lines(path);
  std::string last = "it prints nothing";
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  return last;
}

}  // namespace

PicotoolEnd load_by_picotool(const std::string& file) {
  using enum PicotoolEnd::Kind;
  std::error_code error;
  std::string output =
      (std::filesystem::temp_directory_path(error) / "hedgehogctl-XXXXXX").string();
  const int fd = ::mkstemp(output.data());
  if (fd < 0) return {kFailed, std::string("no temporary file: ") + std::strerror(errno)};
  ::close(fd);
  const std::string path = std::filesystem::absolute(file, error).string();
  const ProgramEnd end = run_program({"picotool", "load", "-x", path}, output);
  PicotoolEnd result{kDone, {}};
  if (end.start_error == ENOENT)
    result.kind = kMissing;
  else if (end.start_error != 0)
    result = {kFailed, std::strerror(end.start_error)};
  else if (!end.succeeded)
    result = {kFailed, last_line(output)};
  ::unlink(output.c_str());
  return result;
}

}  // namespace hedgehog::client
