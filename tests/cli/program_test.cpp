// SPDX-License-Identifier: MIT
// A program's command line: which variables it sets, and how it ends early.
#include "cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sysexits.h>

namespace hedgehog::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

class Sample : public testing::Test {
 protected:
  Sample() {
    program_.set_version("sample 1.0");
    program_.require_commands(0, 1);
    program_.add_option("--level", level_, "of the push").range(0.0, 1.0).show_default();
    program_.add_option("--count", count_, "how often").range(1, 9);
    program_.add_option("--seed", seed_, "of the noise").environment("SAMPLE_SEED");
    program_.add_option("--shape", shape_, "of the wave").one_of({"sine", "square"});
    program_.add_option("--listen", listen_, "where").repeatable();
    program_.add_option("--fields", fields_, "with commas").delimiter(',');
    program_.add_option("--out", out_, "a file, or here").optional_value();
    program_.add_option("--name", name_, "of the ball")
        .check({[](const std::string& text) { return text == "x" ? "not x" : ""; }, "NAME"});
    const auto json = program_.add_flag("--json", json_, "for programs");
    program_.add_flag("--csv", csv_, "for tables").excludes(json);
    program_.add_ignored_flag("--old");
    const auto play = program_.add_command("play", "a pattern");
    play.add_option("pattern", pattern_, "its name");
    play.add_option("--file", file_, "a file");
    play.require_any_of(play.option("pattern"), play.option("--file"), "pattern or --file");
    play.on_given([this] { played_ = true; });
  }

  /// The text of the early exit; "" if there is none.
  std::string end(const Words& words, int code = EX_USAGE) {
    const auto ended = program_.parse(words);
    if (!ended) return "";
    EXPECT_EQ(ended->code, code) << ended->text;
    return ended->text;
  }

  double level_ = 0.5;
  std::optional<int> count_;
  std::uint64_t seed_ = 1;
  std::string shape_ = "sine";
  Words listen_;
  Words fields_;
  std::optional<std::string> out_;
  std::string name_;
  bool json_ = false;
  bool csv_ = false;
  std::string pattern_;
  std::string file_;
  bool played_ = false;
  Program program_{"A sample.", "sample"};
};

TEST_F(Sample, SetsTheVariablesThatAreGivenAndNoOthers) {
  EXPECT_EQ(end({"--level", "0.25", "--listen", "a", "--listen", "b", "--fields", "x,y", "--json",
                 "--shape=square", "--old", "play", "knock"}),
            "");
  EXPECT_EQ(level_, 0.25);
  EXPECT_EQ(count_, std::nullopt);
  EXPECT_THAT(listen_, ElementsAre("a", "b"));
  EXPECT_THAT(fields_, ElementsAre("x", "y"));
  EXPECT_EQ(shape_, "square");
  EXPECT_TRUE(json_ && played_ && !csv_);
  EXPECT_EQ(pattern_, "knock");
  EXPECT_TRUE(program_.is_given("play") && program_.has_given_command());
}

TEST_F(Sample, AcceptsAnOptionWithoutItsValueAndOneFromTheEnvironment) {
  ::setenv("SAMPLE_SEED", "42", 1);
  EXPECT_EQ(end({"--out"}), "");
  ::unsetenv("SAMPLE_SEED");
  EXPECT_EQ(seed_, 42u);
  EXPECT_EQ(out_, "");
  EXPECT_FALSE(played_ || program_.has_given_command());
}

TEST_F(Sample, EndsWithASentenceAfterAUsageError) {
  EXPECT_EQ(end({"--level", "1.5"}),
            "sample: --level: Value 1.5 not in range 0.000000 to 1.000000; see sample --help");
  EXPECT_THAT(end({"--count", "0"}), HasSubstr("--count"));
  EXPECT_THAT(end({"--count", "two"}), HasSubstr("--count"));
  EXPECT_THAT(end({"--shape", "saw"}), HasSubstr("--shape: saw not in {sine,square}"));
  EXPECT_EQ(end({"--name", "x"}), "sample: --name: not x; see sample --help");
  EXPECT_THAT(end({"--csv", "--json"}), HasSubstr("excludes"));
  EXPECT_EQ(end({"play"}), "sample play: pattern or --file is required; see sample play --help");
  EXPECT_EQ(end({"--levle", "1"}),
            "sample: unknown option '--levle'; did you mean '--level'?; see sample --help");
  EXPECT_FALSE(played_);
  EXPECT_EQ(program_.usage_error("no"), "sample: no; see sample --help");
}

TEST_F(Sample, EndsWithTheHelpText) {
  const std::string help = end({"--help"}, EX_OK);
  EXPECT_THAT(help, HasSubstr("A sample."));
  EXPECT_THAT(help, HasSubstr("--level FLOAT:FLOAT in [0 - 1]=0.5"));
  EXPECT_THAT(help, HasSubstr("a pattern"));
  EXPECT_THAT(help, Not(HasSubstr("--old")));
  EXPECT_EQ(end({"--version"}, EX_OK), "sample 1.0\n");
}

TEST(Number, IsTheWholeText) {
  EXPECT_EQ(number_of("1.5"), 1.5);
  EXPECT_EQ(number_of("1.5x"), std::nullopt);
  EXPECT_EQ(number_of("left"), std::nullopt);
}

}  // namespace
}  // namespace hedgehog::cli
