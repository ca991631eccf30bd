// SPDX-License-Identifier: MIT
// hedgehog-design, run within the process of the test.
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "clients/design/command_line.h"
#include "tests/temporary_folder.h"

namespace hedgehog::design {

struct CommandResult {
  int exit_code = -1;
  std::string out;
  std::string err;

  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

inline CommandResult run_design(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  const int exit_code = run_command_line(arguments, out, err);
  return {exit_code, out.str(), err.str()};
}

/// A few pins and shields, far apart: a ball that openscad renders in a second.
inline const char* const kSmallBall =
    "kind,x,y,z\npin,0,0,1\npin,1,0,0.2\npin,-1,0,0.2\npin,0,1,-0.3\npin,0,-1,-0.3\n"
    "shield,1,1,1\nshield,-1,1,1\nshield,1,-1,-0.1\nshield,-1,-1,0\n";

}  // namespace hedgehog::design
