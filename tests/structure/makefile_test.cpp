// SPDX-License-Identifier: MIT
// The commands of `make run`, `make demo` and `make race`, which a new user runs first and which
// must be quick; and the deadline of CI's stages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>
#include <sstream>
#include <string>

#include "tests/folders.h"
#include "tests/temporary_folder.h"

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

/// How cmake/each_target.sh ended, what it printed, and the files that it wrote.
struct TargetsMade {
  int code = 0;
  std::string printed;
  std::string stages;
  std::string failed;
};

TargetsMade make_each(const std::string& targets, const std::string& deadline) {
  const hedgehog::TemporaryFolder folder;
  const std::string stages = folder.path("stages.tsv");
  const std::string command = "cd " + hedgehog::source_folder() +
                              " && MAKE= HEDGEHOG_STAGES=" + stages +
                              " HEDGEHOG_DEADLINE=" + deadline + " cmake/each_target.sh " +
                              targets + " >" + folder.path("printed") + " 2>&1";
  const int code = WEXITSTATUS(std::system(command.c_str()));
  return {code, folder.read("printed"), folder.read("stages.tsv"),
          folder.read("stages.tsv.failed")};
}

TEST(Stages, BeginOnlyBeforeTheDeadline) {
  constexpr const char* kLongAgo = "1";
  constexpr const char* kFarAway = "99999999999";
  for (const std::string deadline : {"", kFarAway}) {
    const TargetsMade made = make_each("help", deadline);
    EXPECT_EQ(made.code, 0) << deadline;
    EXPECT_EQ(made.stages, "") << deadline;
  }
  const TargetsMade skipped = make_each("no-such-target help", kLongAgo);
  EXPECT_EQ(skipped.code, 0);
  EXPECT_EQ(skipped.stages, "late\tno-such-target\nlate\thelp\n");
}

/// The stages of `make test-all`, on a day with these parts.
std::string stages_of(const std::string& parts) {
  return commands_of("computing waiting beside PARTS='" + parts + "'");
}

TEST(Stages, OfThreeDaysAreAllAndEachLongOneIsOfOneDay) {
  const std::string all = stages_of("1 2 3");
  const std::array days{stages_of("1"), stages_of("2"), stages_of("3")};
  for (const std::string stage :
       {"asan-tests", "asan-programs", "fuzz-in-ci", "tidy-in-ci", "alone-in-ci", "tsan-tests",
        "tsan-programs", "test-sdk", "test-usb", "test-web",
        "'test-deb test-service PACKED=build/bench'", "test-install", "rehearsal", "test-shipped",
        "test-bids", "test-monitoring", "test-mqtt", "test-discovery", "test-release"}) {
    const auto found = std::count_if(days.begin(), days.end(), [&](const std::string& stages) {
      return stages.find(stage) != std::string::npos;
    });
    EXPECT_EQ(found, 1) << stage;
    EXPECT_THAT(all, HasSubstr(stage));
  }
}

/// What follows each "cmake/bootstrap.sh" in commands: the lists of packages, cmake/apt/<list>.txt.
std::set<std::string> package_lists_in(const std::string& commands) {
  const std::string script = "cmake/bootstrap.sh ";
  std::set<std::string> lists;
  for (std::size_t at = commands.find(script); at != std::string::npos;
       at = commands.find(script, at + 1)) {
    const std::size_t begin = at + script.size();
    std::istringstream words(commands.substr(begin, commands.find('\n', begin) - begin));
    for (std::string list; words >> list;) lists.insert(list);
  }
  return lists;
}

TEST(Stages, OfEachDayFindTheirPackagesInstalled) {
  constexpr const char* kEach = "cmake/each_target.sh ";
  for (const std::string part : {"1", "2", "3"}) {
    std::string targets = "test ";
    std::istringstream lines(stages_of(part));
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with(kEach)) targets += line.substr(std::strlen(kEach)) + " ";
    std::erase(targets, '\'');
    std::set<std::string> needed = package_lists_in(commands_of("-B " + targets + "PARTS=" + part));
    ASSERT_GE(needed.size(), 6U) << targets;
    // Installed where there is no node.
    EXPECT_EQ(needed.erase("dashboard"), 1U);
    EXPECT_EQ(package_lists_in(commands_of("packages-in-ci PARTS=" + part)), needed) << part;
  }
}

TEST(Stages, OfEachDayAreTheGuardsAndMutantsAndWhatShips) {
  for (const char* part : {"1", "2", "3", "1 2 3"}) {
    const std::string stages = stages_of(part);
    for (const char* stage :
         {"mutations-in-ci", "coverage", " firmware ", "shipped", "instructions", "faults-ci",
          " guards-in-ci", "firmware-guards-in-ci", "test-openrpc", "test-json-rpc"})
      EXPECT_THAT(stages, HasSubstr(stage)) << part;
  }
}

TEST(Stages, OfABusyMachineAreAllThatTestTheProduct) {
  const std::string tests = commands_of("computing-tests PARTS='1 2 3'");
  for (const char* stage : {" firmware ", "shipped", "faults-ci", " guards-in-ci", "asan-programs",
                            "fuzz-in-ci", "tsan-programs"})
    EXPECT_THAT(tests, HasSubstr(stage));
  for (const char* stage : {"mutations-in-ci", "coverage", "tidy-in-ci", "alone-in-ci"})
    EXPECT_THAT(tests, Not(HasSubstr(stage)));
}

TEST(Stages, ThatFailAreNamedAndTheOthersMade) {
  const TargetsMade made = make_each("no-such-target 'help JOBS=1' neither-this", "");
  EXPECT_EQ(made.code, 1);
  EXPECT_EQ(made.stages, "red\tno-such-target\nred\tneither-this\n");
  EXPECT_THAT(made.printed, HasSubstr("make demo"));
  EXPECT_THAT(made.failed, HasSubstr("no-such-target, its last lines:"));
  EXPECT_THAT(made.failed, HasSubstr("No rule to make target 'neither-this'"));
  EXPECT_THAT(made.failed, Not(HasSubstr("make demo")));
}

}  // namespace
