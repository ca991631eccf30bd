// SPDX-License-Identifier: MIT
// Escape sequences that draw a frame on a terminal.
#include "clients/common/terminal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace hedgehog::client {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string written_for(const std::vector<std::string>& lines) {
  testing::internal::CaptureStdout();
  {
    Terminal terminal;
    terminal.draw(lines);
  }
  return testing::internal::GetCapturedStdout();
}

/// The cursor stays in the last column after such a line, and erasing would begin there.
TEST(Terminal, ALineOfFullWidthKeepsItsLastCharacter) {
  const std::string out = written_for({std::string(80, '7')});
  EXPECT_THAT(out, HasSubstr("\033[1;1H\033[K" + std::string(80, '7')));
  EXPECT_THAT(out, Not(HasSubstr("7\033[K")));
}

}  // namespace
}  // namespace hedgehog::client
