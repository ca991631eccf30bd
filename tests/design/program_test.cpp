// SPDX-License-Identifier: MIT
// The program itself: exit codes, what stands on which stream, and every command of its README.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "clients/design/complaint.h"
#include "tests/design/program.h"

namespace hedgehog::design {
namespace {

using testing::HasSubstr;

const std::string kProgram = HEDGEHOG_DESIGN_PATH;

/// A line as a shell runs it, in the folder, with hedgehog-design on the PATH.
Answer shell(const Folder& folder, const std::string& line) {
  const std::string path = std::filesystem::path(kProgram).parent_path().string();
  folder.write("line.sh", "cd '" + folder.path() + "' || exit 99\nPATH=\"" + path + ":$PATH\"\n" +
                              line + "\n");
  const int status = std::system(("sh '" + folder.file("line.sh") + "' >'" + folder.file("out") +
                                  "' 2>'" + folder.file("err") + "'")
                                     .c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder.read("out"), folder.read("err")};
}

TEST(Program, AnswersOnStdoutAndComplainsOnStderr) {
  const Folder folder;
  const Answer good = shell(
      folder, "hedgehog-design pair --magnet 8x10 --other 4x10 --angle 12 --offset 0.5 --json");
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_EQ(good.err, "");
  EXPECT_NEAR(good.json().at("force_n").get<double>(), 5.095441734e-01, 1e-6);
  const Answer bad = shell(folder, "hedgehog-design stability --array wd");
  EXPECT_EQ(bad.exit_code, kUsage);
  EXPECT_EQ(bad.out, "");
  EXPECT_EQ(bad.err, "hedgehog-design: unknown array 'wd'; did you mean 'wD'?\n");
  EXPECT_EQ(shell(folder, "hedgehog-design array --magnet 12x10").exit_code, kBadData);
  EXPECT_EQ(shell(folder, "hedgehog-design --help").exit_code, 0);
  EXPECT_THAT(shell(folder, "hedgehog-design --version").out, HasSubstr("hedgehog-design "));
}

TEST(Program, SaysWhichPackageIsMissing) {
  const Folder folder;
  folder.write("small.csv", kSmallBall);
  const Answer picture =
      shell(folder, "PATH=/nowhere " + kProgram + " curves --array cD --png c.png");
  EXPECT_EQ(picture.exit_code, kUnavailable);
  EXPECT_EQ(picture.err,
            "hedgehog-design: gnuplot is not installed; on Debian: apt install gnuplot-nox\n");
  const Answer casing =
      shell(folder, "PATH=/nowhere " + kProgram + " export --positions small.csv --stl c");
  EXPECT_EQ(casing.exit_code, kUnavailable);
  EXPECT_THAT(casing.err, HasSubstr("apt install openscad"));
}

TEST(Program, SaysThatNoTemporaryFileCanBeMade) {
  const Folder folder;
  folder.write("small.csv", kSmallBall);
  for (const char* command : {"curves --array cD --png c.png", "report --array cD",
                              "export --positions small.csv --stl c"}) {
    const Answer answer = shell(folder, "TMPDIR=/nowhere hedgehog-design " + std::string(command));
    EXPECT_EQ(answer.exit_code, kCannotCreate) << command;
    EXPECT_THAT(answer.err, HasSubstr("no temporary file can be made")) << command;
  }
}

TEST(Program, SearchesShowNoBarIntoFiles) {
  const Folder folder;
  const Answer answer =
      shell(folder, "hedgehog-design choose --arrays cD --shields 4.4x10 --spheres 35 --json");
  EXPECT_EQ(answer.exit_code, 0);
  EXPECT_EQ(answer.err, "");
  EXPECT_EQ(answer.json().at("looked_at"), 1);
}

/// The lines of all ``` blocks that begin with the program's name.
std::vector<std::string> readme_commands() {
  std::ifstream readme(std::string(HEDGEHOG_SOURCE_DIR) + "/clients/design/README.md");
  std::vector<std::string> commands;
  bool fenced = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.rfind("```", 0) == 0) fenced = !fenced;
    if (fenced && line.rfind("hedgehog-design ", 0) == 0) commands.push_back(line);
  }
  return commands;
}

TEST(Readme, EveryCommandRuns) {
  const Folder folder;
  const auto commands = readme_commands();
  ASSERT_GE(commands.size(), 15U);
  for (const std::string& command : commands) {
    if (command.find("--stl") != std::string::npos) {
      // The same command, over a ball that openscad renders in a second and not in minutes.
      EXPECT_THAT(folder.read("best.json"), HasSubstr("\"tkD-86\""))
          << "the search before it saved the ball";
      folder.write("small.csv", kSmallBall);
      folder.write("best.json", R"({"array": "tkD-86", "positions": "small.csv"})");
      const Answer casing = shell(folder, command);
      EXPECT_EQ(casing.exit_code, 0) << command << "\n" << casing.err;
      EXPECT_THAT(casing.err, HasSubstr("casing/lower.stl  closed"));
      folder.write("best.json", R"({"array": "tkD-86"})");
      continue;
    }
    const Answer answer = shell(folder, command);
    EXPECT_EQ(answer.exit_code, 0) << command << "\n" << answer.err;
  }
  for (const char* made : {"casing.scad", "my-ball.json", "report.html", "curves.svg", "curves.png",
                           "coil.png", "pins.csv"}) {
    EXPECT_GT(folder.read(made).size(), 100U) << made;
  }
}

}  // namespace
}  // namespace hedgehog::design
