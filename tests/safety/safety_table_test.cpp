// SPDX-License-Identifier: MIT
// The filters with a wildcard at their beginning that the safety table gives select tests of this
// program. Those without one are checked by tests/structure.
#include <fnmatch.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "tests/folders.h"

namespace hedgehog::safety {
namespace {

std::vector<std::string> tests_of_this_program() {
  std::vector<std::string> names;
  const ::testing::UnitTest& program = *::testing::UnitTest::GetInstance();
  for (int i = 0; i < program.total_test_suite_count(); ++i) {
    const ::testing::TestSuite& suite = *program.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count(); ++k)
      names.push_back(std::string(suite.name()) + "." + suite.GetTestInfo(k)->name());
  }
  return names;
}

TEST(SafetyTable, ItsFiltersSelectTests) {
  std::ifstream page(source_folder() + "/daemon/safety.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  const std::vector<std::string> tests = tests_of_this_program();
  const std::regex name("`(\\*[^`]*|/[A-Z][A-Za-z]*_\\*)`");
  int checked = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), name), none; at != none; ++at) {
    // A further fault of the filter before it.
    const std::string filter = at->str(1).front() == '/' ? "*" + at->str(1) : at->str(1);
    EXPECT_TRUE(std::any_of(tests.begin(), tests.end(), [&](const std::string& test) {
      return ::fnmatch(filter.c_str(), test.c_str(), 0) == 0;
    })) << filter;
    ++checked;
  }
  EXPECT_GT(checked, 15);
}

}  // namespace
}  // namespace hedgehog::safety
