// SPDX-License-Identifier: MIT
// The board core is compiled unchanged into firmware. Its own compile flags (-ffreestanding
// -nostdinc++ -fno-exceptions -fno-rtti) check that it needs no C++ library; these tests check the
// rest.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include "tests/folders.h"

namespace {

std::string without_comments(const std::string& text) {
  static const std::regex kComment("//[^\n]*");
  return std::regex_replace(text, kComment, "");
}

TEST(BoardCoreSources, AreFreestandingAndFixedPoint) {
  const std::filesystem::path folder =
      std::filesystem::path(hedgehog::source_folder()) / "daemon/device/board_core";
  static const std::regex kInclude("#include\\s*([<\"][^>\"]*[>\"])");
  static const std::regex kForbidden(
      "\\b(float|double|new|delete|malloc|free|throw|try|catch|typeid|dynamic_cast|"
      "virtual|std|thread_local)\\b");
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp") continue;
    ++files;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const std::string code = without_comments(text.str());
    for (std::sregex_iterator it(code.begin(), code.end(), kInclude), end; it != end; ++it) {
      const std::string name = (*it)[1];
      EXPECT_TRUE(name == "<stdint.h>" || name == "<stddef.h>" ||
                  name.starts_with("\"daemon/device/board_core/"))
          << entry.path().filename() << " includes " << name;
    }
    std::smatch found;
    EXPECT_FALSE(std::regex_search(code, found, kForbidden))
        << entry.path().filename() << ": " << found.str();
  }
  EXPECT_GE(files, 6);
}

}  // namespace
