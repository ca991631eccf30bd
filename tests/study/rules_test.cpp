// SPDX-License-Identifier: MIT
// The staircase's levels as integers, against the published traces: uninterrupted and resumed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "clients/study/experiment_file.h"
#include "clients/study/rules/trace.h"
#include "tests/folders.h"
#include "tests/study/preset.h"

namespace hedgehog::study {
namespace {

using nlohmann::json;

Experiment experiment_of(const json& trace) {
  static const char* const kNames[] = {"force-threshold-thesis", "force-jnd", "speed-jnd"};
  return preset(kNames[trace["experiment"].get<int>() - 1]);
}

const json& traces() {
  static const json kAll = [] {
    std::ifstream file(source_folder() + "/tests/study/data/traces.json");
    return json::parse(file)["traces"];
  }();
  return kAll;
}

std::vector<std::string> text(const std::vector<Level>& levels, const Experiment& e) {
  std::vector<std::string> decimals;
  decimals.reserve(levels.size());
  for (const Level level : levels) decimals.push_back(exact_decimal(level, e.decimals()));
  return decimals;
}

TEST(Traces, AreReproducedExactly) {
  ASSERT_EQ(traces().size(), 18U);
  for (const json& expected : traces()) {
    SCOPED_TRACE(expected["id"].get<std::string>());
    const Experiment e = experiment_of(expected);
    const auto traced = trace(e, expected["responses"].get<std::string>());
    const Trace& t = std::get<Trace>(traced);
    EXPECT_EQ(json(text(t.levels, e)), expected["levels"]);
    EXPECT_EQ(json(text(t.reversals, e)), expected["reversal_levels"]);
    EXPECT_EQ(t.threshold ? json(*t.threshold) : json(nullptr), expected["threshold"]);
    EXPECT_EQ(name(t.status), expected["status"].get<std::string>());
    EXPECT_EQ(t.scored, expected["n_scored"]);
    EXPECT_EQ(t.catches, expected["n_catch"]);
    EXPECT_EQ(t.false_alarms, expected["false_alarms"]);
    EXPECT_EQ(t.voids, expected["n_void"]);
    EXPECT_EQ(t.floor_hits, expected["floor_hits"]);
    EXPECT_EQ(t.ceiling_hits, expected["ceil_hits"]);
    EXPECT_EQ(t.unused, expected["unused_tokens"]);
  }
}

TEST(Traces, AgreeEventByEvent) {
  static const char* const kMoves[] = {"down", "none", "up"};
  for (const json& expected : traces()) {
    SCOPED_TRACE(expected["id"].get<std::string>());
    const Experiment e = experiment_of(expected);
    const Trace t = std::get<Trace>(trace(e, expected["responses"].get<std::string>()));
    std::size_t scored = 0;
    for (const json& event : expected["events"]) {
      if (event["kind"] != "scored") continue;
      SCOPED_TRACE(event.dump());
      const Step& step = t.steps[scored++];
      EXPECT_EQ(exact_decimal(step.level, e.decimals()), event["level"]);
      EXPECT_EQ(kMoves[step.move + 1], event["move"]);
      EXPECT_EQ(step.reversal, event["reversal"]);
      EXPECT_EQ(step.run, event["run_after"]);
      EXPECT_EQ(exact_decimal(step.step_up, e.decimals()), event["delta_up_after"]);
      EXPECT_EQ(step.next ? json(exact_decimal(*step.next, e.decimals())) : json(nullptr),
                event["next_level"]);
    }
    EXPECT_EQ(scored, t.steps.size());
  }
}

TEST(Traces, AreTheSameWhenTheStaircaseIsRestoredAfterEveryFewEvents) {
  for (const json& expected : traces()) {
    const Experiment e = experiment_of(expected);
    for (const int few : {1, 3, 7}) {
      SCOPED_TRACE(expected["id"].get<std::string>() + " " + std::to_string(few));
      std::vector<Level> levels;
      Staircase staircase(e.rule);
      for (const char token : expected["responses"].get<std::string>()) {
        if (staircase.over()) break;
        if (levels.size() % static_cast<std::size_t>(few) == 0) {
          const StaircaseState saved = staircase.state();
          staircase = Staircase(e.rule, saved);
        }
        levels.push_back(token == 'Y' || token == 'N' ? 0 : staircase.level());
        if (token == '0' || token == '1') staircase.answer(token == '1');
      }
      EXPECT_EQ(json(text(levels, e)), expected["levels"]);
      EXPECT_EQ(json(text(staircase.state().reversals, e)), expected["reversal_levels"]);
      EXPECT_EQ(name(staircase.status()), expected["status"].get<std::string>());
    }
  }
}

TEST(Staircase, CountsReversalsBeyondTheRangeOfInt) {
  StaircaseRule rule;
  rule.stages.assign(3000, {1, 1, 1'000'000});
  EXPECT_GT(rule.total_reversals(), 2'000'000'000);
}

TEST(Staircase, IsAbortedAfterItsMaximumOfTrials) {
  Experiment e = preset("force-jnd");
  e.rule.max_trials = 12;
  const Trace t = std::get<Trace>(trace(e, std::string(12, '1') + "11"));
  EXPECT_EQ(t.status, Status::kAbortedMaxTrials);
  EXPECT_FALSE(t.threshold);
  EXPECT_EQ(t.unused, 2);
}

TEST(Staircase, AcceptsOtherRules) {
  Experiment e = preset("speed-jnd");
  e.rule.positives_down = 3;
  e.rule.negatives_up = 2;
  e.rule.quick_start = false;
  const Trace t = std::get<Trace>(trace(e, "1110100111"));
  EXPECT_EQ(text(t.levels, e),
            (std::vector<std::string>{"100", "100", "100", "78.048", "78.048", "78.048", "78.048",
                                      "118.048", "118.048", "118.048"}));
  EXPECT_EQ(text(t.reversals, e), (std::vector<std::string>{"78.048", "118.048"}));
}

TEST(Staircase, RefusesInvalidTokens) {
  EXPECT_EQ(std::get<std::string>(trace(preset("force-jnd"), "11Y")),
            "response 3: 'Y' is a catch trial, and force-jnd has none");
  EXPECT_EQ(std::get<std::string>(trace(preset("force-jnd"), "x")),
            "response 1: 'x' is none of 1, 0, Y, N, T");
}

TEST(Level, IsAnExactDecimal) {
  EXPECT_EQ(exact_decimal(44512, 4), "4.4512");
  EXPECT_EQ(exact_decimal(50000, 4), "5");
  EXPECT_EQ(exact_decimal(7, 3), "0.007");
  EXPECT_EQ(exact_decimal(-1500, 3), "-1.5");
  EXPECT_EQ(mean_decimal(std::vector<Level>{1, 1, 2}, 0), "1.333333333333");
  EXPECT_EQ(mean_decimal(std::vector<Level>{2, 2, 1}, 0), "1.666666666667");
  EXPECT_EQ(mean_decimal(std::vector<Level>{-2, -2, -1}, 0), "-1.666666666667");
  EXPECT_EQ(from_value(0.0001, 4), 1);
  EXPECT_FALSE(from_value(0.00015, 4));
}

RC_GTEST_PROP(Level, RoundTrips, ()) {
  const auto level = *rc::gen::inRange<Level>(-3'000'000, 3'000'000);
  RC_ASSERT(from_value(std::stod(exact_decimal(level, 4)), 4) == level);
}

std::string answers() {
  return *rc::gen::container<std::string>(60, rc::gen::weightedElement<char>({{4, '1'}, {1, '0'}}));
}

RC_GTEST_PROP(Staircase, VoidsAndCatchTrialsAnywhereChangeNothing, ()) {
  const Experiment e = preset("force-threshold");
  std::string mixed;
  const std::string plain = answers();
  for (const char token : plain)
    mixed += *rc::gen::element<std::string>("", "T", "Y", "N", "TYT") + token;
  const Trace a = std::get<Trace>(trace(e, plain));
  const Trace b = std::get<Trace>(trace(e, mixed));
  RC_ASSERT(a.steps == b.steps);
  RC_ASSERT(a.reversals == b.reversals);
  RC_ASSERT(a.threshold == b.threshold);
}

RC_GTEST_PROP(Staircase, StaysWithinItsLimitsAndReversesWhereReported, ()) {
  const Experiment e =
      preset(*rc::gen::element<std::string>("force-threshold", "force-jnd", "speed-jnd"));
  const Trace t = std::get<Trace>(trace(e, answers()));
  int direction = 0;
  std::size_t reversals = 0;
  for (const Step& step : t.steps) {
    RC_ASSERT(step.level >= e.rule.floor && step.level <= e.rule.ceiling);
    RC_ASSERT(step.next.value_or(e.rule.floor) >= e.rule.floor);
    const bool turns = step.move != 0 && direction != 0 && step.move != direction;
    RC_ASSERT(turns == (step.reversal > 0));
    if (turns) RC_ASSERT(t.reversals[reversals++] == step.level);
    direction = step.move != 0 ? step.move : direction;
  }
  RC_ASSERT(reversals == t.reversals.size());
  RC_ASSERT((t.status == Status::kFinished) ==
            (static_cast<int>(reversals) == e.rule.total_reversals()));
}

}  // namespace
}  // namespace hedgehog::study
