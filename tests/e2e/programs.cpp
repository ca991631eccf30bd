// SPDX-License-Identifier: MIT
#include "tests/e2e/programs.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace hedgehog::e2e {
namespace {

/// Of a sanitizer's build, when these are not this build's.
const char* other_build() { return std::getenv("HEDGEHOG_PROGRAMS"); }

std::string program(const std::string& place) {
  if (const char* other = other_build()) {
    const std::filesystem::path path = std::filesystem::absolute(other) / place;
    if (std::filesystem::exists(path)) return path.string();
  }
  return HEDGEHOG_BUILD_DIR "/" + place;
}

}  // namespace

std::string hedgehogd() { return program("daemon/hedgehogd"); }
std::string hedgehogctl() { return program("clients/ctl/hedgehogctl"); }
std::string hedgehog_orientation() { return program("clients/orientation/hedgehog-orientation"); }
std::string hedgehog_racer() { return program("clients/racer/hedgehog-racer"); }
std::string hedgehog_study() { return program("clients/study/hedgehog-study"); }
std::string hedgehog_usbip() { return program("daemon/emulator/hedgehog-usbip"); }

int attainable_speed(int wanted) { return other_build() != nullptr ? std::min(wanted, 4) : wanted; }

}  // namespace hedgehog::e2e
