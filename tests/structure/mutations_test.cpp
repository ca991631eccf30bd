// SPDX-License-Identifier: MIT
// The lists of tests/mutations must name all files of the safety code, and only lines that exist.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>

#include "tests/folders.h"
#include "tests/structure/source_tree.h"

namespace hedgehog::structure {
namespace {

const SourceFile* file_named(const SourceTree& tree, const std::string& path) {
  const auto at = std::find_if(tree.files.begin(), tree.files.end(),
                               [&](const SourceFile& file) { return file.path == path; });
  return at == tree.files.end() ? nullptr : &*at;
}

// The second word of each line whose first word is one of `begins`.
std::set<std::string> listed(const SourceFile& list, const std::set<std::string>& begins) {
  std::set<std::string> found;
  for (const std::string& line : list.lines) {
    const std::size_t gap = line.find(' ');
    if (gap != std::string::npos && begins.count(line.substr(0, gap)) != 0)
      found.insert(line.substr(gap + 1, line.find(' ', gap + 1) - gap - 1));
  }
  return found;
}

TEST(Mutations, CoverTheWholeSafetyCode) {
  const SourceTree tree = read_tree(source_folder());
  const SourceFile* scope = file_named(tree, "tests/mutations/scope.txt");
  ASSERT_NE(scope, nullptr);
  const std::set<std::string> all = listed(*scope, {"file", "covered"});
  for (const std::string& path : all) EXPECT_NE(file_named(tree, path), nullptr) << path;
  const std::regex safety(
      "(model/((estimate|limit|thermal)/(thermal_[a-z_]*|energy_floor|resistance_fall"
      "|winding_thermometer))"
      "|daemon/control/(checks/(watchdog|supply_balance|[a-z_]*_check)|state/state_machine"
      "|drive|current_prediction|winding_visibility|controller[a-z_]*)"
      "|daemon/device/(link|board_core/[a-z_0-9]*))[.]cpp");
  const std::set<std::string> reporting{"daemon/control/controller_snapshot.cpp"};
  for (const SourceFile& file : tree.files) {
    if (!std::regex_match(file.path, safety) || reporting.count(file.path) != 0) continue;
    EXPECT_TRUE(all.count(file.path) != 0) << file.path << " is not in tests/mutations/scope.txt";
  }
}

TEST(Mutations, OfBoardCoreLimiterAndWatchdogEveryLineIsExecuted) {
  const SourceTree tree = read_tree(source_folder());
  const SourceFile* scope = file_named(tree, "tests/mutations/scope.txt");
  ASSERT_NE(scope, nullptr);
  const std::set<std::string> covered = listed(*scope, {"covered"});
  const std::regex enforced(
      "(model/limit/thermal_limiter|daemon/control/checks/(watchdog|supply_balance|[a-z_]*_check)"
      "|daemon/device/board_core/[a-z_0-9]*)[.]cpp");
  for (const SourceFile& file : tree.files) {
    if (!std::regex_match(file.path, enforced)) continue;
    EXPECT_TRUE(covered.count(file.path) != 0) << file.path;
  }
}

TEST(Mutations, ExplainedLinesExist) {
  const SourceTree tree = read_tree(source_folder());
  const SourceFile* list = file_named(tree, "tests/mutations/explained.txt");
  ASSERT_NE(list, nullptr);
  const SourceFile* file = nullptr;
  for (const std::string& line : list->lines) {
    if (line.starts_with("file ")) {
      file = file_named(tree, line.substr(5));
      ASSERT_NE(file, nullptr) << line;
    } else if (line.starts_with("line ")) {
      ASSERT_NE(file, nullptr) << line;
      const bool exists =
          std::any_of(file->lines.begin(), file->lines.end(), [&](const std::string& text) {
            const std::size_t first = text.find_first_not_of(' ');
            return first != std::string::npos && text.substr(first) == line.substr(5);
          });
      EXPECT_TRUE(exists) << line;
    }
  }
}

}  // namespace
}  // namespace hedgehog::structure
