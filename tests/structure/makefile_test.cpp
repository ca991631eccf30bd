// SPDX-License-Identifier: MIT
// The commands of `make run`, `make demo` and `make race`, which a new user runs first and which
// must be quick; and the deadline of CI's stages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
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

TEST(FirstRun, BuildsOnlyThePrograms) {
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

/// The prerequisites of a file, "clients/dashboard/index.html ...", in make's list of rules.
std::string prerequisites_of(const std::string& file) {
  const std::string rules = commands_of("-p dashboard racer-page");
  const std::string begin = "\n" + file + ": ";
  const std::size_t at = rules.find(begin);
  if (at == std::string::npos) return "";
  return rules.substr(at + begin.size(), rules.find('\n', at + 1) - at - begin.size());
}

TEST(Pages, AreRebuiltWhenTheirSourcesChange) {
  for (const std::string page : {"www", "racer"}) {
    const std::string prerequisites =
        prerequisites_of("build/run/share/hedgehog/" + page + "/index.html");
    for (const char* script : {"build.sh", "cmake/bundle.sh", "cmake/compress.sh", "cmake/npm.sh",
                               "clients/dashboard/package-lock.json", "icon.svg"})
      EXPECT_THAT(prerequisites, HasSubstr(script)) << page;
  }
}

int in_time(const std::string& deadline) {
  const std::string command = "HEDGEHOG_STAGES= HEDGEHOG_DEADLINE=" + deadline + " " +
                              hedgehog::source_folder() + "/cmake/in_time.sh test-web 2>/dev/null";
  return WEXITSTATUS(std::system(command.c_str()));
}

TEST(Stages, BeginOnlyBeforeTheDeadline) {
  constexpr const char* kLongAgo = "1";
  constexpr const char* kFarAway = "99999999999";
  EXPECT_EQ(in_time(""), 0) << "outside of CI there is none";
  EXPECT_EQ(in_time(kFarAway), 0);
  EXPECT_EQ(in_time(kLongAgo), 1);
}

}  // namespace
