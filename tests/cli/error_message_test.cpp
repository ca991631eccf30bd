// SPDX-License-Identifier: MIT
#include "cli/error_message.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/cli/sample_app.h"

namespace hedgehog::cli {
namespace {

/// The error message; "" for a valid command line.
std::string message_of(std::vector<std::string> words) {
  SampleApp sample;
  std::reverse(words.begin(), words.end());
  try {
    sample.app.parse(words);
  } catch (const CLI::ParseError& error) {
    return usage_error(sample.app, error_message(sample.app, error));
  }
  return "";
}

TEST(ErrorMessage, NamesTheNearestVerb) {
  EXPECT_EQ(message_of({"pusj", "left"}),
            "sample: there is no verb 'pusj'; did you mean 'push'?; sample --help says more");
  EXPECT_EQ(message_of({"preview", "pusj"}),
            "sample preview: there is no verb 'pusj'; did you mean 'push'?; sample preview --help "
            "says more");
  EXPECT_EQ(message_of({"lists", "remvoe"}),
            "sample lists: there is no verb 'remvoe'; did you mean 'remove'?; sample lists --help "
            "says more")
      << "where none is needed, too";
  EXPECT_EQ(message_of({"lists"}), "");
  EXPECT_EQ(message_of({"frobnicate"}),
            "sample: there is no verb 'frobnicate'; sample --help says more");
}

TEST(ErrorMessage, NamesTheNearestOption) {
  EXPECT_EQ(
      message_of({"push", "left", "--speeed", "3"}),
      "sample push: '--speeed' is not understood; did you mean '--speed'?; sample push --help "
      "says more");
  EXPECT_EQ(message_of({"push", "left", "--adress=x"}),
            "sample push: '--adress=x' is not understood; did you mean '--address'?; sample push "
            "--help says more")
      << "those of the program too";
  EXPECT_EQ(message_of({"push", "left", "--loud"}),
            "sample push: '--loud' is not understood; sample push --help says more");
}

TEST(ErrorMessage, NamesTheMissingArgument) {
  EXPECT_EQ(message_of({}), "sample: a verb is missing; sample --help says more");
  EXPECT_EQ(message_of({"push"}), "sample push: --side is required; sample push --help says more");
  EXPECT_EQ(message_of({"push", "left"}), "");
}

}  // namespace
}  // namespace hedgehog::cli
