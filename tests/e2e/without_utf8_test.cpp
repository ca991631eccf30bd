// SPDX-License-Identifier: MIT
// The programs in a locale without UTF-8.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;

bool is_ascii(const std::string& text) {
  return std::all_of(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

struct CommandLine {
  std::string program;
  std::vector<std::string> arguments;
};

class WithoutUtf8 : public testing::Test {
 protected:
  Ended run(const CommandLine& line, const std::string& locale) const {
    return Program(home_, line.program, line.arguments,
                   {"HEDGEHOG_ADDRESS=" + daemon_.socket(), "LC_ALL=" + locale})
        .wait();
  }

  Home home_;
  DaemonProcess daemon_{home_};
};

TEST_F(WithoutUtf8, EachProgramPrintsAscii) {
  const std::vector<CommandLine> lines{
      {hedgehogctl(), {"status"}},
      {hedgehog_orientation(), {"--seconds", "1"}},
      {hedgehog_racer(), {"lap", "--seconds", "3"}},
      {hedgehog_study(), {"simulate", "force-threshold", "--observers", "1"}},
      {hedgehog_design(), {"pair", "--magnet", "8x10", "--other", "4x10", "--angle", "12"}},
      {hedgehog_design(), {"pair", "--help"}},
  };
  for (const CommandLine& line : lines) {
    SCOPED_TRACE(line.program + " " + line.arguments.front());
    const Ended utf8 = run(line, "C.UTF-8");
    EXPECT_EQ(utf8.exit_code, 0) << utf8.err;
    EXPECT_FALSE(is_ascii(utf8.out + utf8.err)) << utf8.out << utf8.err;
    const Ended ascii = run(line, "C");
    EXPECT_EQ(ascii.exit_code, 0) << ascii.err;
    EXPECT_TRUE(is_ascii(ascii.out + ascii.err)) << ascii.out << ascii.err;
  }
}

TEST_F(WithoutUtf8, JsonStaysWhatItIs) {
  RawClient other(daemon_.port());
  other.call("hello", {{"client", "up to 41 °C"}});
  EXPECT_THAT(run({hedgehogctl(), {"clients", "--json"}}, "C").out, HasSubstr("up to 41 °C"));
  EXPECT_THAT(run({hedgehogctl(), {"clients"}}, "C").out, HasSubstr("up to 41 C"));
}

}  // namespace
}  // namespace hedgehog::e2e
