// SPDX-License-Identifier: MIT
// Arguments that are rejected before any action.
#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/command_line.h"
#include "tests/temporary_folder.h"

namespace hedgehog::study {
namespace {

namespace fs = std::filesystem;

/// Exit code of the program in an empty folder, which must still be empty afterwards.
int exit_code_of(std::vector<const char*> words) {
  const TemporaryFolder empty;
  const fs::path before = fs::current_path();
  words.insert(words.begin(), {"hedgehog-study", "-C", empty.path().c_str()});
  const int code = run_command_line(static_cast<int>(words.size()), words.data());
  fs::current_path(before);
  EXPECT_TRUE(fs::is_empty(empty.path()));
  return code;
}

TEST(CommandLine, AcceptsFiniteNumbersWithinTheirRange) {
  for (const char* wrong : {"nan", "-nan", "inf", "0", "16", "1e400"})
    EXPECT_EQ(exit_code_of({"levels", "--threshold-a", wrong}), EX_USAGE) << wrong;
  for (const char* option : {"--force-percent", "--speed-percent"})
    EXPECT_EQ(exit_code_of({"levels", option, "nan"}), EX_USAGE) << option;
  EXPECT_EQ(exit_code_of({"levels", "--threshold-a", "2.1"}), 0);
  // Rejected before the search for a study, which would find none (EX_NOINPUT).
  for (const char* wrong : {"nan", "9", "31"}) {
    EXPECT_EQ(exit_code_of({"run", "force-jnd", "--participant", "P01", "--hand-size", wrong}),
              EX_USAGE)
        << wrong;
  }
  EXPECT_EQ(exit_code_of({"run", "force-jnd", "--participant", "P01", "--hand-size", "18.4"}),
            EX_NOINPUT);
  for (const char* wrong : {"old", "24", "29-22"}) {
    EXPECT_EQ(exit_code_of({"run", "force-jnd", "--participant", "P01", "--age-band", wrong}),
              EX_USAGE)
        << wrong;
  }
  for (const char* wrong : {"18,3", "18.3 foo"}) {
    EXPECT_EQ(exit_code_of({"run", "force-jnd", "--participant", "P01", "--hand-size", wrong}),
              EX_USAGE)
        << wrong;
  }
}

TEST(CommandLine, CreatesNoStudyInAFolderWithoutAName) {
  EXPECT_EQ(exit_code_of({"plan", ""}), EX_USAGE);
}

}  // namespace
}  // namespace hedgehog::study
