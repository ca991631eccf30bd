// SPDX-License-Identifier: MIT
// The program: exit codes, the contents of stdout and stderr, and every command of its README and
// of verbs.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "clients/common/problem.h"
#include "tests/design/program.h"
#include "tests/folders.h"

namespace hedgehog::design {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kProgram = build_folder() + "/clients/design/hedgehog-design";

/// Runs a command line in a shell, in the folder, with hedgehog-design on the PATH.
CommandResult shell(const TemporaryFolder& folder, const std::string& line) {
  const std::string path = std::filesystem::path(kProgram).parent_path().string();
  folder.write("line.sh", "cd '" + folder.path() + "' || exit 99\nPATH=\"" + path + ":$PATH\"\n" +
                              line + "\n");
  const int status = std::system(("sh '" + folder.path("line.sh") + "' >'" + folder.path("out") +
                                  "' 2>'" + folder.path("err") + "'")
                                     .c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder.read("out"), folder.read("err")};
}

TEST(Program, PrintsResultsOnStdoutAndErrorsOnStderr) {
  const TemporaryFolder folder;
  const CommandResult good = shell(
      folder, "hedgehog-design pair --magnet 8x10 --other 4x10 --angle 12 --offset 0.5 --json");
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_EQ(good.err, "");
  EXPECT_NEAR(good.json().at("force_n").get<double>(), 5.095441734e-01, 1e-6);
  const CommandResult bad = shell(folder, "hedgehog-design stability --array wd");
  EXPECT_EQ(bad.exit_code, kUsage);
  EXPECT_EQ(bad.out, "");
  EXPECT_EQ(bad.err, "hedgehog-design: unknown array 'wd'; did you mean 'wD'?\n");
  EXPECT_EQ(shell(folder, "hedgehog-design array --magnet 12x10").exit_code, kBadData);
  EXPECT_EQ(shell(folder, "hedgehog-design --help").exit_code, 0);
  EXPECT_THAT(shell(folder, "hedgehog-design --version").out, HasSubstr("hedgehog-design "));
}

TEST(Program, NamesTheMissingPackage) {
  const TemporaryFolder folder;
  folder.write("small.csv", kSmallBall);
  const CommandResult picture =
      shell(folder, "PATH=/nowhere " + kProgram + " curves --array cD --png c.png");
  EXPECT_EQ(picture.exit_code, kUnavailable);
  EXPECT_EQ(picture.err,
            "hedgehog-design: gnuplot is not installed; on Debian: apt install gnuplot-nox\n");
  const CommandResult casing =
      shell(folder, "PATH=/nowhere " + kProgram + " export --positions small.csv --stl c");
  EXPECT_EQ(casing.exit_code, kUnavailable);
  EXPECT_THAT(casing.err, HasSubstr("apt install openscad"));
}

TEST(Program, ReportsThatNoTemporaryFileCanBeCreated) {
  const TemporaryFolder folder;
  folder.write("small.csv", kSmallBall);
  for (const char* command : {"curves --array cD --png c.png", "report --array cD",
                              "export --positions small.csv --stl c"}) {
    const CommandResult result =
        shell(folder, "TMPDIR=/nowhere hedgehog-design " + std::string(command));
    EXPECT_EQ(result.exit_code, kCannotCreate) << command;
    EXPECT_THAT(result.err, HasSubstr("no temporary file can be made")) << command;
  }
}

/// Drops root's permission to write everywhere during its lifetime.
class UnprivilegedUser {
 public:
  UnprivilegedUser() {
    if (was_root_ && ::seteuid(65534) != 0) ADD_FAILURE();
  }
  UnprivilegedUser(const UnprivilegedUser&) = delete;
  UnprivilegedUser& operator=(const UnprivilegedUser&) = delete;
  ~UnprivilegedUser() {
    if (was_root_ && ::seteuid(0) != 0) ADD_FAILURE();
  }

 private:
  bool was_root_ = ::geteuid() == 0;
};

TEST(Program, AnUnwritableFolderIsNamed) {
  const TemporaryFolder folder;
  const std::string closed = folder.path("closed");
  std::filesystem::create_directory(closed);
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  std::filesystem::permissions(closed, std::filesystem::perms(0555));
  const std::string csv = folder.write("small.csv", kSmallBall);
  const UnprivilegedUser user;
  const auto refused = [](const std::vector<std::string>& words) {
    const CommandResult result = run_design(words);
    EXPECT_EQ(result.exit_code, kCannotCreate) << words.front() << result.out;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
  };
  const std::string reason = " cannot be written: Permission denied\n";
  for (const auto& [words, file] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"report", "--array", "cD", "--output"}, "/r.html"},
           {{"curves", "--array", "cD", "--svg"}, "/c.svg"},
           {{"electromagnet", "--array", "tkD", "--png"}, "/e.png"},
           {{"array", "--save"}, "/a.json"},
           {{"export", "--csv"}, "/p.csv"},
           {{"export", "--device"}, "/ball.json"},
           {{"export", "--scad"}, "/c.scad"},
           // Reported before the search, not after it.
           {{"choose", "--save"}, "/best.json"},
           {{"choose", "--png"}, "/front.png"}}) {
    auto command = words;
    command.push_back(closed + file);
    EXPECT_EQ(refused(command), "hedgehog-design: " + closed + file + reason);
  }
  EXPECT_THAT(refused({"export", "--positions", csv, "--stl", closed + "/casing"}),
              HasSubstr(closed + "/casing cannot be made: Permission denied"));
  ::setenv("TMPDIR", closed.c_str(), 1);
  EXPECT_THAT(refused({"report", "--array", "cD", "--output", "/dev/null"}),
              HasSubstr("no temporary file can be made in " + closed + ": Permission denied"));
  ::unsetenv("TMPDIR");
}

TEST(BadInput, GetsOneClearSentence) {
  const TemporaryFolder folder;
  const auto wrong = [](const std::vector<std::string>& words, int exit_code) {
    const CommandResult result = run_design(words);
    EXPECT_EQ(result.exit_code, exit_code) << words.front();
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_THAT(result.err, StartsWith("hedgehog-design"));
    return result.err;
  };
  EXPECT_THAT(wrong({"stability", "--array", "tkd"}, kUsage), HasSubstr("did you mean 'tkD'?"));
  EXPECT_THAT(wrong({"pair", "--magnet", "-8x10", "--angle", "12"}, kUsage), HasSubstr("--magnet"));
  EXPECT_THAT(wrong({"pair", "--sphere", "-35", "--angle", "12"}, kUsage), HasSubstr("--sphere"));
  EXPECT_THAT(wrong({"pair", "--angle", "5"}, kBadData), HasSubstr("overlap"));
  EXPECT_THAT(wrong({"pair", "--angle", "200"}, kUsage), HasSubstr("--angle"));
  EXPECT_THAT(wrong({"pair"}, kUsage), HasSubstr("--angle"));
  EXPECT_THAT(wrong({"pair", "--angle", "12", "--offset", "-40"}, kUsage),
              HasSubstr("beyond the centre of a sphere of 35 mm"));
  EXPECT_THAT(wrong({"curves", "--sphere", "10", "--array", "D", "--magnet", "1x1", "--shield",
                     "1x1", "--offsets", "-20..2/1"},
                    kUsage),
              HasSubstr("beyond the centre of a sphere of 10 mm"));
  EXPECT_THAT(wrong({"stability", "--sphere", "1"}, kUsage), HasSubstr("outside 5 to 500 mm"));
  EXPECT_THAT(wrong({"stability", "--sphere", "500", "--magnet", "0.1x0.1", "--shield", "0.1x0.1"},
                    kBadData),
              HasSubstr("too far apart to hold anything"));
  EXPECT_THAT(wrong({"stability", "--array", "GP(8,0)", "--remove-pins", "5", "--magnet", "1x2",
                     "--shield", "0.5x2", "--sphere", "60"},
                    kBadData),
              HasSubstr("328 of its pins differ"));
  EXPECT_THAT(wrong({"curves", "--model", "fem"}, kUsage), HasSubstr("exact, hybrid, dipole"));
  EXPECT_THAT(wrong({"curves", "--accuracy", "2"}, kUsage), HasSubstr("--accuracy"));
  EXPECT_THAT(wrong({"curves", "--accuracy", "-1"}, kUsage), HasSubstr("--accuracy"));
  EXPECT_THAT(wrong({"stability", "--positions", folder.write("a.csv", "{}")}, kBadData),
              HasSubstr("no CSV"));
  EXPECT_THAT(wrong({"stability", folder.write("b.json", "kind,x,y,z")}, kBadData),
              HasSubstr("b.json:1: not valid JSON"));
  EXPECT_THAT(wrong({"stability", folder.path("none.json")}, kNoInput), HasSubstr("none.json"));
  EXPECT_THAT(wrong({"stability", folder.path()}, kNoInput), HasSubstr("is a folder"));
  EXPECT_THAT(wrong({"curves", "--png", folder.path("x.gif")}, kUsage), HasSubstr(".svg or .png"));
  EXPECT_THAT(wrong({"report", "--output", folder.path("no/report.html")}, kCannotCreate),
              HasSubstr("cannot be written"));
  EXPECT_THAT(wrong({"export"}, kUsage), HasSubstr("give at least one of"));
  EXPECT_THAT(wrong({}, kUsage), HasSubstr("a verb is missing"));
  EXPECT_THAT(wrong({"stablity"}, kUsage), HasSubstr("no verb 'stablity'"));
  EXPECT_THAT(wrong({"stability", "--aray", "cD"}, kUsage), HasSubstr("'--aray'"));
}

TEST(Program, AnOutputThatCannotBeWrittenIsAnError) {
  const TemporaryFolder folder;
  const CommandResult full = shell(folder, "hedgehog-design pair --angle 12 >/dev/full");
  EXPECT_EQ(full.exit_code, kCannotCreate);
  EXPECT_EQ(full.err, "hedgehog-design: the answer cannot be written\n");
}

TEST(Program, AnExistingFileStaysUntilItsReplacementIsComplete) {
  const TemporaryFolder folder;
  folder.write("gnuplot", "#!/bin/sh\necho no room >&2\nexit 3\n");
  std::filesystem::permissions(folder.path("gnuplot"), std::filesystem::perms(0755));
  folder.write("good.svg", "a good picture");
  const CommandResult failed = shell(folder, "PATH=\"" + folder.path() +
                                                 ":$PATH\" hedgehog-design curves --array cD --svg "
                                                 "good.svg --csv");
  EXPECT_EQ(failed.exit_code, kToolFailed);
  EXPECT_THAT(failed.err, HasSubstr("gnuplot failed: no room"));
  EXPECT_EQ(folder.read("good.svg"), "a good picture");
  const std::string design = R"({"array": "cD"})";
  const std::string file = folder.write("best.json", design);
  for (const auto& words : std::vector<std::vector<std::string>>{{"report", "--output"},
                                                                 {"export", "--scad"},
                                                                 {"export", "--csv"},
                                                                 {"export", "--device"}}) {
    auto command = words;
    command.push_back(file);
    if (words.back() == "--scad") command.insert(command.end(), {"--array", "cD"});
    const CommandResult refused = run_design(command);
    EXPECT_EQ(refused.exit_code, kUsage) << words.back();
    EXPECT_THAT(refused.err, HasSubstr("is a design file and is not written over"));
    EXPECT_EQ(folder.read("best.json"), design) << words.back();
  }
}

TEST(Program, SearchesShowNoProgressBarInAFile) {
  const TemporaryFolder folder;
  const CommandResult result =
      shell(folder, "hedgehog-design choose --arrays cD --shields 4.4x10 --spheres 35 --json");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.json().at("looked_at"), 1);
}

/// The lines of all ``` blocks of the README and of verbs.md that begin with the program's name.
std::vector<std::string> readme_commands() {
  std::vector<std::string> commands;
  for (const char* page : {"README.md", "verbs.md"}) {
    std::ifstream text(source_folder() + "/clients/design/" + page);
    bool fenced = false;
    for (std::string line; std::getline(text, line);) {
      if (line.rfind("```", 0) == 0) fenced = !fenced;
      if (fenced && line.rfind("hedgehog-design ", 0) == 0) commands.push_back(line);
    }
  }
  return commands;
}

TEST(Readme, EveryCommandRuns) {
  const TemporaryFolder folder;
  const auto commands = readme_commands();
  ASSERT_GE(commands.size(), 15U);
  for (const std::string& command : commands) {
    if (command.find("--stl") != std::string::npos) {
      // The same command, for a ball that openscad renders in a second and not in minutes.
      EXPECT_THAT(folder.read("best.json"), HasSubstr("\"tkD-86\""))
          << "the search before it saved the ball";
      folder.write("small.csv", kSmallBall);
      folder.write("best.json", R"({"array": "tkD-86", "positions": "small.csv"})");
      const CommandResult casing = shell(folder, command);
      EXPECT_EQ(casing.exit_code, 0) << command << "\n" << casing.err;
      EXPECT_THAT(casing.err, HasSubstr("casing/lower.stl  closed"));
      folder.write("best.json", R"({"array": "tkD-86"})");
      continue;
    }
    const CommandResult result = shell(folder, command);
    EXPECT_EQ(result.exit_code, 0) << command << "\n" << result.err;
  }
  for (const char* made : {"casing.scad", "my-ball.json", "report.html", "curves.svg", "curves.png",
                           "coil.png", "pins.csv"})
    EXPECT_GT(folder.read(made).size(), 100U) << made;
}

}  // namespace
}  // namespace hedgehog::design
