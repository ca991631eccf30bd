// SPDX-License-Identifier: MIT
// hedgehog-design, run within the test, or as a process of its own.
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "clients/design/command_line.h"

namespace hedgehog::design {

struct Answer {
  int exit_code = -1;
  std::string out;
  std::string err;

  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

inline Answer ask(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  const int exit_code = run_command_line(arguments, out, err);
  return {exit_code, out.str(), err.str()};
}

/// A folder that is gone with the test.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "design-test-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
    return file(name);
  }
  std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(file(name)).rdbuf();
    return text.str();
  }
  const std::string& path() const noexcept { return path_; }

 private:
  std::string path_;
};

/// Seven pins and a few shields, wide apart: a ball that openscad renders in a second.
inline const char* const kSmallBall =
    "kind,x,y,z\npin,0,0,1\npin,1,0,0.2\npin,-1,0,0.2\npin,0,1,-0.3\npin,0,-1,-0.3\n"
    "shield,1,1,1\nshield,-1,1,1\nshield,1,-1,-0.1\nshield,-1,-1,0\n";

}  // namespace hedgehog::design
