// SPDX-License-Identifier: MIT
// The log of a real daemon in a file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>

#include "tests/e2e/daemon_process.h"

namespace hedgehog::e2e {
namespace {

/// A desktop terminal's shell passes JOURNAL_STREAM on: the journal stream of another process.
TEST(Log, AJournalOfAnotherProgramDisablesNoOutput) {
  const Home home;
  DaemonProcess daemon(home, {}, {"JOURNAL_STREAM=8:12345"});
  EXPECT_TRUE(daemon.logs("listening on "));
}

TEST(Log, EachLineOfAFileHasDateTimeAndLevel) {
  const Home home;
  DaemonProcess daemon(home);
  ASSERT_TRUE(daemon.logs("listening on "));
  const std::regex line_form(
      R"(\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{3}[+-]\d\d:\d\d (info|warning|error) .*)");
  std::istringstream log(daemon.log());
  for (std::string line; std::getline(log, line);)
    EXPECT_TRUE(std::regex_match(line, line_form)) << line;
}

}  // namespace
}  // namespace hedgehog::e2e
