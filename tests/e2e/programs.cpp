// SPDX-License-Identifier: MIT
#include "tests/e2e/programs.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace hedgehog::e2e {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDaemon = "daemon/hedgehogd";

std::string program(const std::string& place) {
  if (const char* other = std::getenv("HEDGEHOG_PROGRAMS")) {
    const fs::path folder = fs::absolute(other);
    if (fs::exists(folder / place)) return folder / place;
    if (!fs::exists(folder / kDaemon))
      throw std::runtime_error("HEDGEHOG_PROGRAMS: no " + (folder / kDaemon).string());
  }
  return HEDGEHOG_BUILD_DIR "/" + place;
}

}  // namespace

std::string hedgehogd() { return program(kDaemon); }
std::string hedgehogctl() { return program("clients/ctl/hedgehogctl"); }
std::string hedgehog_orientation() { return program("clients/orientation/hedgehog-orientation"); }
std::string hedgehog_racer() { return program("clients/racer/hedgehog-racer"); }
std::string hedgehog_study() { return program("clients/study/hedgehog-study"); }
std::string hedgehog_usbip() { return program("emulator/hedgehog-usbip"); }

int attainable_speed(int wanted) {
  const char* limit = std::getenv("HEDGEHOG_SPEED_LIMIT");
  return limit != nullptr ? std::min(wanted, std::stoi(limit)) : wanted;
}

}  // namespace hedgehog::e2e
