// SPDX-License-Identifier: MIT
// Experiment files: the presets have the thesis' parameters; errors name line and key.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clients/study/experiment_file.h"

namespace hedgehog::study {
namespace {

using testing::HasSubstr;

TEST(Presets, HaveTheThesisParameters) {
  const StaircaseRule one = find_experiment("force-threshold-thesis").value().rule;
  EXPECT_EQ(one.start, 50000);
  EXPECT_EQ(one.ceiling, 150000);
  EXPECT_EQ(one.stages, (std::vector<Stage>{{10000, 5488, 5}, {5000, 2744, 5}, {2500, 1372, 5}}));
  EXPECT_EQ(one.total_reversals(), 15);
  const StaircaseRule two = find_experiment("force-jnd").value().rule;
  EXPECT_EQ(two.start, 100000);
  EXPECT_EQ(two.ceiling, 200000);
  EXPECT_EQ(two.stages, (std::vector<Stage>{{20000, 10976, 3}, {10000, 5488, 3}, {5000, 2744, 4}}));
  const StaircaseRule three = find_experiment("speed-jnd").value().rule;
  EXPECT_EQ(three.ceiling, 300000);
  EXPECT_EQ(three.stages,
            (std::vector<Stage>{{40000, 21952, 3}, {20000, 10976, 3}, {10000, 5488, 4}}));
  for (const Preset& preset : presets()) {
    const Experiment e = find_experiment(std::string(preset.name)).value();
    EXPECT_EQ(e.name, preset.name);
    EXPECT_EQ(e.rule.positives_down, 2);
    EXPECT_EQ(e.rule.negatives_up, 1);
    EXPECT_TRUE(e.rule.quick_start);
    EXPECT_EQ(e.rule.discard, 2);
    EXPECT_EQ(e.rule.max_trials, 200);
    EXPECT_EQ(e.pattern, Pattern{});
  }
  EXPECT_EQ(find_experiment("force-threshold").value().catch_one_in, 6);
  EXPECT_EQ(find_experiment("force-threshold-thesis").value().catch_one_in, 0);
}

TEST(Presets, HaveTheStimuliOfTheThesis) {
  const Experiment two = find_experiment("force-jnd").value();
  EXPECT_EQ(reference_stimulus(two), (Stimulus{5, 10}));
  EXPECT_EQ(test_stimulus(two, two.rule.start), (Stimulus{10, 10}));
  EXPECT_EQ(test_stimulus(two, two.rule.ceiling), (Stimulus{15, 10}));
  const Experiment three = find_experiment("speed-jnd").value();
  EXPECT_EQ(test_stimulus(three, three.rule.start), (Stimulus{5, 20}));
  EXPECT_EQ(test_stimulus(three, three.rule.ceiling), (Stimulus{5, 40}));
  EXPECT_EQ(test_stimulus(find_experiment("force-threshold").value(), 34512),
            (Stimulus{3.4512, 10}));
}

TEST(ExperimentFile, ANulEndsNoFile) {
  const std::string good = experiment_text(find_experiment("force-jnd").value());
  EXPECT_THAT(
      parse_experiment("\n" + good.substr(0, 1) + '\0' + good.substr(1), "mine").error().message,
      testing::Eq("mine:2: not valid JSON: has a NUL byte, which JSON never has"));
  EXPECT_FALSE(parse_experiment(good + '\0' + "garbage", "mine").has_value());
}

TEST(ExperimentFile, ReadsBackWhatItWrites) {
  for (const Preset& preset : presets()) {
    Experiment e = find_experiment(std::string(preset.name)).value();
    EXPECT_EQ(parse_experiment(experiment_text(e), "again").value(), e);
    e.rule.stages.front() = {3, 2, 4};  // a ratio unlike that of the other stages
    EXPECT_EQ(parse_experiment(experiment_text(e), "again").value(), e);
  }
}

std::string changed(std::string_view from, std::string_view to) {
  std::string text(presets().front().text);
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string error_message(const std::string& text) {
  const auto read = parse_experiment(text, "mine.json");
  EXPECT_FALSE(read.has_value());
  return read ? "" : read.error().message;
}

TEST(ExperimentFile, NamesEachErrorByLineAndKey) {
  ASSERT_EQ(presets().front().name, "force-jnd");
  EXPECT_THAT(error_message(changed("\"discard\"", "\"dicard\"")),
              testing::MatchesRegex(
                  "mine.json:[0-9]+: dicard: unknown key; did you mean \"discard\"\\?.*"));
  EXPECT_THAT(error_message(changed("\"task\": \"two_intervals\"", "\"task\": \"three\"")),
              HasSubstr("task: must be \"yes_no\" or \"two_intervals\", not \"three\""));
  EXPECT_THAT(error_message(changed("\"ceiling\": 200", "\"ceiling\": 220")),
              HasSubstr("ceiling: is 16 A"));
  EXPECT_THAT(error_message(changed("\"current_a\": 5", "\"current_a\": 0")),
              testing::MatchesRegex("mine.json:[0-9]+: current_a: must be above 0.*"));
  EXPECT_THAT(error_message(changed("\"start\": 100", "\"start\": 0.0001")),
              HasSubstr("start: has more than 3 decimals"));
  // The line of the key itself, not that of a comment, value or stage with the same name.
  EXPECT_THAT(error_message("// \"gap_ms\": 1\n{ \"question\": \"gap_ms\", /* \"gap_ms\":\n */\n"
                            "\"stages\": [{\"gap_ms\": 2}],\n \"gap_ms\" : -1}"),
              HasSubstr("mine.json:5: gap_ms: must be 0 to 10000, not -1"));
  EXPECT_THAT(error_message("{\n\"a\""), HasSubstr("mine.json:2: not valid JSON"));
  EXPECT_THAT(error_message("{\n\"a\": 1e999}"), HasSubstr("mine.json:2: not valid JSON"));
  EXPECT_THAT(error_message("{}"), HasSubstr("stages: is missing"));
  for (const std::string key : {"start", "floor", "ceiling"})
    EXPECT_THAT(error_message("{\"" + key + "\": null}"),
                HasSubstr("mine.json:1: " + key + ": must be a number, 0 to 1000000, not null"));
  EXPECT_THAT(error_message("{\"discard\": 1, \"discard\": 2}"), HasSubstr("discard: given twice"));
  EXPECT_THAT(error_message(changed("\"step_up\": 20", "\"step_up\": -1")),
              HasSubstr("steps must be above 0"));
  EXPECT_THAT(error_message(changed("\"name\": \"force-jnd\"", "\"name\": \"../x\"")),
              HasSubstr("name: takes small letters"));
  EXPECT_THAT(error_message(changed("\"question\": \"", "\"question\": \"a\\n")),
              HasSubstr("question: must be a text of one line, not \"a\\u000a"));
  EXPECT_EQ(find_experiment("/tmp").error().exit_code, EX_NOINPUT);
  EXPECT_EQ(find_experiment("nothing").error().exit_code, EX_USAGE);
  EXPECT_EQ(find_experiment("./nothing.json").error().exit_code, EX_NOINPUT);
}

}  // namespace
}  // namespace hedgehog::study
