// SPDX-License-Identifier: MIT
// tests/guards/guards.txt names lines of the source; they must still be there.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/structure/source_tree.h"

namespace hedgehog::structure {
namespace {

const SourceFile* find(const SourceTree& tree, const std::string& path) {
  const auto at = std::find_if(tree.files.begin(), tree.files.end(),
                               [&](const SourceFile& file) { return file.path == path; });
  return at == tree.files.end() ? nullptr : &*at;
}

std::string text_of(const SourceFile& file) {
  std::string text;
  for (const std::string& line : file.lines) text += line + "\n";
  return text;
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::string with_line_ends(std::string text) {
  for (auto at = text.find("\\n"); at != std::string::npos; at = text.find("\\n"))
    text.replace(at, 2, "\n");
  return text;
}

TEST(Guards, StandWhereTheListSays) {
  const SourceTree tree = read_tree(HEDGEHOG_SOURCE_DIR);
  const SourceFile* list = find(tree, "tests/guards/guards.txt");
  ASSERT_NE(list, nullptr);
  std::string text;
  int guards = 0;
  for (const std::string& line : list->lines) {
    if (line.starts_with("file ")) {
      const SourceFile* file = find(tree, line.substr(5));
      ASSERT_NE(file, nullptr) << line;
      text = text_of(*file);
    } else if (line.starts_with("cut ")) {
      EXPECT_EQ(count(text, with_line_ends(line.substr(4))), 1) << line;
      ++guards;
    } else if (line.starts_with("red ")) {
      const std::string program = line.substr(4, line.find(' ', 4) - 4);
      const bool has_tests = std::any_of(
          tree.files.begin(), tree.files.end(),
          [&](const SourceFile& file) { return file.path.starts_with("tests/" + program + "/"); });
      EXPECT_TRUE(has_tests) << line;
    }
  }
  EXPECT_GE(guards, 49);
}

}  // namespace
}  // namespace hedgehog::structure
