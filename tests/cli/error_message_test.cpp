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
            "sample: there is no verb 'pusj'; did you mean 'push'?; see sample --help");
  EXPECT_EQ(
      message_of({"preview", "pusj"}),
      "sample preview: there is no verb 'pusj'; did you mean 'push'?; see sample preview --help");
  EXPECT_EQ(
      message_of({"lists", "remvoe"}),
      "sample lists: there is no verb 'remvoe'; did you mean 'remove'?; see sample lists --help")
      << "where none is needed, too";
  EXPECT_EQ(message_of({"lists"}), "");
  EXPECT_EQ(message_of({"frobnicate"}), "sample: there is no verb 'frobnicate'; see sample --help");
}

TEST(ErrorMessage, NamesTheNearestOption) {
  EXPECT_EQ(
      message_of({"push", "left", "--speeed", "3"}),
      "sample push: unknown option '--speeed'; did you mean '--speed'?; see sample push --help");
  EXPECT_EQ(
      message_of({"push", "left", "--adress=x"}),
      "sample push: unknown option '--adress=x'; did you mean '--address'?; see sample push --help")
      << "those of the program too";
  EXPECT_EQ(message_of({"push", "left", "--loud"}),
            "sample push: unknown option '--loud'; see sample push --help");
}

TEST(ErrorMessage, NamesTheMissingArgument) {
  EXPECT_EQ(message_of({}), "sample: a verb is missing; see sample --help");
  EXPECT_EQ(message_of({"push"}), "sample push: --side is required; see sample push --help");
  EXPECT_EQ(message_of({"push", "left"}), "");
}

}  // namespace
}  // namespace hedgehog::cli
