// SPDX-License-Identifier: MIT
// What `make run`, `make demo` and `make race` would do: somebody who tries the ball waits for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

#include "tests/folders.h"

namespace {

using testing::HasSubstr;
using testing::Not;

std::string commands_of(const std::string& target) {
  const std::string command =
      "make -n -C " + hedgehog::source_folder() + " " + target + " 2>/dev/null";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string out;
  std::array<char, 4096> bytes{};
  for (std::size_t count = 1; count > 0;) {
    count = std::fread(bytes.data(), 1, bytes.size(), pipe);
    out.append(bytes.data(), count);
  }
  ::pclose(pipe);
  return out;
}

TEST(FirstRun, BuildsOnlyWhatItStarts) {
  const std::string build = "cmake --build --preset run";
  const auto expect_only = [&](const std::string& target, const std::string& programs) {
    const std::string commands = commands_of(target);
    EXPECT_THAT(commands, HasSubstr(build + " --target " + programs + "\n")) << target;
    EXPECT_THAT(commands, Not(HasSubstr(build + "\n"))) << target;
  };
  expect_only("run", "hedgehogd");
  expect_only("demo", "hedgehogd hedgehogctl");
  expect_only("race", "hedgehog-racer");
  expect_only("tools", "hedgehogctl");
  EXPECT_THAT(commands_of("release"), HasSubstr("cmake --build --preset release\n"))
      << "and that builds all";
}

/// "clients/dashboard/index.html ..." of "FILE: ..." in make's own list of rules.
std::string prerequisites_of(const std::string& file) {
  const std::string rules = commands_of("-p dashboard racer-page");
  const std::string begin = "\n" + file + ": ";
  const std::size_t at = rules.find(begin);
  if (at == std::string::npos) return "";
  return rules.substr(at + begin.size(), rules.find('\n', at + 1) - at - begin.size());
}

TEST(Pages, AreMadeAgainWhenWhatMakesThemChanges) {
  for (const std::string page : {"www", "racer"}) {
    const std::string prerequisites =
        prerequisites_of("build/run/share/hedgehog/" + page + "/index.html");
    for (const char* script : {"build.sh", "cmake/bundle.sh", "cmake/compress.sh", "cmake/npm.sh",
                               "clients/dashboard/package-lock.json", "icon.svg"})
      EXPECT_THAT(prerequisites, HasSubstr(script)) << page;
  }
}

}  // namespace
