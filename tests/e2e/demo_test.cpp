// SPDX-License-Identifier: MIT
// The demo on a simulated ball of its own: its output lines match its descriptions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"

namespace hedgehog::e2e {
namespace {

namespace fs = std::filesystem;
using testing::DoubleNear;
using testing::ElementsAre;

class Demo : public testing::Test {
 protected:
  /// As installed: the daemon in the program's directory.
  Demo() {
    fs::create_directories(home_.path("tmp"));
    fs::create_directories(home_.path("bin"));
    fs::copy_file(hedgehogctl(), installed_);
    fs::create_symlink(hedgehogd(), home_.path("bin/hedgehogd"));
  }

  std::vector<std::string> variables() const { return {"TMPDIR=" + home_.path("tmp")}; }
  /// What the demo has left among the temporary files.
  std::vector<fs::path> left_behind() const {
    const fs::directory_iterator folder(home_.path("tmp"));
    return {begin(folder), end(folder)};
  }
  /// How many processes have a file of this test's folder on their command line, as the demo's
  /// daemon has.
  int processes() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
      // Reading that of a process that ends meanwhile fails.
      std::ostringstream words;
      words << std::ifstream(entry.path() / "cmdline", std::ios::binary).rdbuf();
      count += words.str().find(home_.path("tmp")) != std::string::npos ? 1 : 0;
    }
    return count;
  }

  Home home_;
  const std::string installed_ = home_.path("bin/hedgehogctl");
};

/// The first capture of each match of `pattern`, line by line.
std::vector<std::string> captures(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at)
    found.push_back((*at)[1]);
  return found;
}

/// The currents in A on the lines that begin with `words`.
std::vector<double> currents(const std::string& text, const std::string& words) {
  std::vector<double> found;
  for (const std::string& number : captures(text, " s  " + words + R"( +([\d.]+) A)"))
    found.push_back(std::stod(number));
  return found;
}

TEST_F(Demo, PlaysEveryChapterAndMeetsItsChecks) {
  Program demo(home_, installed_, {"demo", "--private"}, variables());
  const Ended ended = demo.wait();
  ASSERT_EQ(ended.exit_code, 0) << ended.out << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(ended.out.find('\033'), std::string::npos);

  EXPECT_THAT(captures(ended.out, R"( s  pulse (\w+) +[\d.]+ A   [1-9]\d pins felt)"),
              ElementsAre("left", "right", "front", "back", "up", "down"));
  EXPECT_THAT(currents(ended.out, "pulse \\w+"), testing::Each(DoubleNear(10.0, 0.15)));
  EXPECT_THAT(currents(ended.out, "circle 10 pins/s"), ElementsAre(DoubleNear(5.0, 0.15)));
  EXPECT_THAT(currents(ended.out, "vibrate down"), ElementsAre(DoubleNear(8.0, 0.15)));
  EXPECT_THAT(currents(ended.out, "hold up"),
              ElementsAre(DoubleNear(5.0, 0.15), DoubleNear(15.0, 0.15)));
  const auto passed = captures(ended.out, R"(circle .* A   pins [\d ]+ … \((\d+) passed)");
  ASSERT_EQ(passed.size(), 1u) << ended.out;
  EXPECT_GE(std::stoi(passed[0]), 55);
  const auto vibrations = captures(ended.out, R"(vibrate down .* A   (\d+) pins felt)");
  ASSERT_EQ(vibrations.size(), 1u) << ended.out;
  EXPECT_GE(std::stoi(vibrations[0]), 10);
  EXPECT_LT(ended.out.find("hold up            15."), ended.out.find("derating")) << ended.out;
  EXPECT_THAT(ended.out, testing::HasSubstr(" ticks, none skipped"));
  EXPECT_EQ(captures(ended.out, R"( s  (derating) +1\d\.\d A allowed)").size(), 1u) << ended.out;
  EXPECT_THAT(ended.out, testing::ContainsRegex("rest +[0-9]+\\.[0-9] A allowed"));

  const auto hottest = captures(ended.out, R"(Hottest winding (\d+\.\d) )");
  ASSERT_EQ(hottest.size(), 1u) << ended.out;
  EXPECT_GT(std::stod(hottest[0]), 60.0);
  EXPECT_LT(std::stod(hottest[0]), 70.0);
  const auto derated = captures(ended.out, R"(derated to (\d+\.\d) A, never cut)");
  ASSERT_EQ(derated.size(), 1u) << ended.out;
  EXPECT_GT(std::stod(derated[0]), 5.0);
  EXPECT_LT(std::stod(derated[0]), 15.0);
  EXPECT_THAT(ended.out, testing::HasSubstr("All coils are off."));
  EXPECT_THAT(ended.out, testing::HasSubstr("hedgehogctl pulse left"));

  EXPECT_THAT(left_behind(), testing::IsEmpty());
  EXPECT_EQ(processes(), 0);
}

TEST_F(Demo, CtrlCEndsItsDaemonToo) {
  Program demo(home_, installed_, {"demo", "--private"}, variables());
  ASSERT_TRUE(demo.prints("pulse left"));
  EXPECT_EQ(processes(), 1);
  EXPECT_EQ(left_behind().size(), 1u);
  demo.signal(SIGINT);
  const Ended ended = demo.wait();
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_THAT(ended.err, testing::HasSubstr("the coils are off"));
  EXPECT_THAT(left_behind(), testing::IsEmpty());
  EXPECT_EQ(processes(), 0);
}

TEST_F(Demo, WithoutATemporaryFolderIsAnErrorOfItsKind) {
  const std::vector<std::string> missing_folder{"TMPDIR=" + home_.path("nowhere")};
  const Ended ended =
      Program(home_, installed_, {"demo", "--private", "--json"}, missing_folder).wait();
  EXPECT_EQ(ended.exit_code, 69);
  EXPECT_THAT(ended.err, testing::StartsWith(R"({"error":{"code":null,)"));
  EXPECT_THAT(ended.err, testing::HasSubstr("no temporary folder"));
}

TEST_F(Demo, OnATerminalItDrawsAndCtrlCRestoresTheTerminal) {
  TerminalProgram demo(home_, installed_, {"demo", "--private"}, variables());
  ASSERT_TRUE(demo.shows("\033[?1049h"));
  EXPECT_TRUE(demo.shows("a push has a side"));
  EXPECT_TRUE(demo.shows(R"("direction":"left","current_a":10,"duration_ms":400)"));
  EXPECT_TRUE(demo.shows("●"));
  demo.type("\x03");
  EXPECT_EQ(demo.wait(), 130);
  EXPECT_THAT(demo.shown(), testing::HasSubstr("\033[?25h\033[?1049l"));
  EXPECT_TRUE(demo.is_restored());
  EXPECT_THAT(left_behind(), testing::IsEmpty());
  EXPECT_EQ(processes(), 0);
}

}  // namespace
}  // namespace hedgehog::e2e
