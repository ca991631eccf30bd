// SPDX-License-Identifier: MIT
#include "clients/common/ascii_output.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/folders.h"

namespace hedgehog::client {
namespace {

TEST(InAscii, WritesThePrintedCharactersInAscii) {
  EXPECT_EQ(in_ascii("41.2 °C"), "41.2 C");
  EXPECT_EQ(in_ascii("tilted 12° left"), "tilted 12 deg left");
  EXPECT_EQ(in_ascii("ball · armed, 12 µs, thermometer_disa…"),
            "ball - armed, 12 us, thermometer_disa...");
  EXPECT_EQ(in_ascii("plain"), "plain");
}

TEST(InAscii, LeavesExternalTextUnchanged) { EXPECT_EQ(in_ascii("Gäste"), "Gäste"); }

bool is_ascii(const std::string& text) {
  return std::all_of(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// Sources whose non-ASCII characters a terminal without UTF-8 never gets: `bar` replaces its own,
/// and the HTML report.
bool is_not_printed(const std::string& path) {
  return path.ends_with("/terminal/bar.cpp") || path.ends_with("/report/html.cpp");
}

TEST(InAscii, CoversEachCharacterThatTheSourcesPrint) {
  int seen = 0;
  for (const char* folder : {"/clients", "/daemon/server", "/protocol"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(source_folder() + std::string(folder))) {
      if (entry.path().extension() != ".cpp" || is_not_printed(entry.path())) continue;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) {
        line.resize(std::min(line.find("//"), line.size()));
        if (is_ascii(line)) continue;
        EXPECT_TRUE(is_ascii(in_ascii(line))) << entry.path() << ": " << line;
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 20);
}

}  // namespace
}  // namespace hedgehog::client
