// SPDX-License-Identifier: MIT
// The tests that the tables of hazards and threats name must exist.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "tests/folders.h"
#include "tests/structure/source_tree.h"

namespace hedgehog::structure {
namespace {

std::string without_spaces(const SourceFile& file) {
  std::string text;
  for (const std::string& line : file.lines)
    std::copy_if(line.begin(), line.end(), std::back_inserter(text),
                 [](unsigned char c) { return std::isspace(c) == 0; });
  return text;
}

/// "Suite.Name" of each TEST, TEST_F, TEST_P and property in C++.
std::vector<std::string> tests_of(const SourceTree& tree) {
  std::vector<std::string> tests;
  for (const SourceFile& file : tree.files) {
    if (!file.path.starts_with("tests/") || !file.path.ends_with(".cpp")) continue;
    const std::string text = without_spaces(file);
    for (const std::string macro : {"TEST(", "TEST_F(", "TEST_P(", "_PROP("}) {
      for (auto at = text.find(macro); at != std::string::npos; at = text.find(macro, at + 1)) {
        const auto begin = at + macro.size();
        const auto comma = text.find(',', begin);
        const auto end = text.find_first_of(",)", comma + 1);
        if (end == std::string::npos) break;
        tests.push_back(text.substr(begin, comma - begin) + "." +
                        text.substr(comma + 1, end - comma - 1));
      }
    }
  }
  return tests;
}

/// The names in backquotes: `Suite.Name`, `Suite.*`, `Suite.Begin…`.
std::vector<std::string> named_in(const SourceFile& page) {
  std::vector<std::string> names;
  const std::regex name("`([A-Z][A-Za-z0-9]*\\.[A-Za-z0-9]*)(\\*|…)?`");
  for (const std::string& line : page.lines)
    for (std::sregex_iterator at(line.begin(), line.end(), name), none; at != none; ++at)
      names.push_back(at->str(1));
  return names;
}

TEST(NamedTests, Exist) {
  const SourceTree tree = read_tree(source_folder());
  const std::vector<std::string> tests = tests_of(tree);
  ASSERT_GT(tests.size(), 1000u);
  int checked = 0;
  for (const SourceFile& page : tree.files) {
    if (page.path != "SECURITY.md" && page.path != "daemon/safety.md") continue;
    for (const std::string& name : named_in(page)) {
      EXPECT_TRUE(std::any_of(tests.begin(), tests.end(),
                              [&](const std::string& test) { return test.starts_with(name); }))
          << page.path << ": " << name;
      ++checked;
    }
  }
  EXPECT_GT(checked, 40);
}

}  // namespace
}  // namespace hedgehog::structure
