// SPDX-License-Identifier: MIT
// Each line that a list of guards quotes must still be in its source file.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/folders.h"
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

/// Number of guards in a list. Each line to be cut out must occur in its file exactly once.
int guards_in_place(const SourceTree& tree, const std::string& path) {
  const SourceFile* list = find(tree, path);
  if (list == nullptr) return 0;
  std::string text;
  int guards = 0;
  for (const std::string& line : list->lines) {
    if (line.starts_with("file ")) {
      const SourceFile* file = find(tree, line.substr(5));
      EXPECT_NE(file, nullptr) << line;
      text = file == nullptr ? "" : text_of(*file);
    } else if (line.starts_with("cut ")) {
      EXPECT_EQ(count(text, with_line_ends(line.substr(4))), 1) << line;
      ++guards;
    }
  }
  return guards;
}

TEST(Guards, AreWhereTheListPlacesThem) {
  const SourceTree tree = read_tree(source_folder());
  EXPECT_GE(guards_in_place(tree, "tests/guards/guards.txt"), 49);
  EXPECT_GE(guards_in_place(tree, "tests/firmware/emulated/guards.txt"), 23);
}

TEST(Guards, NameExistingTestPrograms) {
  const SourceTree tree = read_tree(source_folder());
  for (const std::string& line : find(tree, "tests/guards/guards.txt")->lines) {
    if (!line.starts_with("red ")) continue;
    const std::string program = line.substr(4, line.find(' ', 4) - 4);
    const bool has_tests = std::any_of(
        tree.files.begin(), tree.files.end(),
        [&](const SourceFile& file) { return file.path.starts_with("tests/" + program + "/"); });
    EXPECT_TRUE(has_tests) << line;
  }
}

}  // namespace
}  // namespace hedgehog::structure
