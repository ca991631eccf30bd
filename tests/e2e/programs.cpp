// SPDX-License-Identifier: MIT
#include "tests/e2e/programs.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "tests/folders.h"

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
  return build_folder() + "/" + place;
}

}  // namespace

std::string hedgehogd() { return program(kDaemon); }
std::string hedgehogctl() { return program("clients/ctl/hedgehogctl"); }
std::string hedgehog_design() { return program("clients/design/hedgehog-design"); }
std::string hedgehog_gamepad() { return program("clients/gamepad/hedgehog-gamepad"); }
std::string hedgehog_mqtt() { return program("clients/mqtt/hedgehog-mqtt"); }
std::string hedgehog_orientation() { return program("clients/orientation/hedgehog-orientation"); }
std::string hedgehog_racer() { return program("clients/racer/hedgehog-racer"); }
std::string hedgehog_study() { return program("clients/study/hedgehog-study"); }
std::string hedgehog_usbip() { return program("emulator/hedgehog-usbip"); }

std::vector<std::string> installed_programs() {
  std::ifstream file(source_folder() + "/cmake/install.cmake");
  const std::string rules{std::istreambuf_iterator<char>(file), {}};
  const std::regex rule(R"(install\(TARGETS((?:\s+hedgehog[a-z-]*)+)\s+RUNTIME)");
  std::smatch match;
  std::regex_search(rules, match, rule);
  std::istringstream names(match[1]);
  std::vector<std::string> paths;
  for (std::string name; names >> name;) {
    const std::string suffix = name.substr(name.rfind('-') + 1);
    const bool is_of_daemon = name == "hedgehogd" || name == "hedgehog-simboard";
    const std::string folder = is_of_daemon            ? "daemon"
                               : name == "hedgehogctl" ? "clients/ctl"
                                                       : "clients/" + suffix;
    paths.push_back(program(folder + "/" + name));
  }
  return paths;
}

int attainable_speed(int wanted) {
  const char* limit = std::getenv("HEDGEHOG_SPEED_LIMIT");
  return limit != nullptr ? std::min(wanted, std::stoi(limit)) : wanted;
}

}  // namespace hedgehog::e2e
