// SPDX-License-Identifier: MIT
// hedgehog-study with mistakes that happen in a lab: each ends with an error message and an exit
// code, and no data is attributed to another run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/e2e/programs.h"
#include "tests/e2e/study_fixture.h"
#include "tests/folders.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;

/// Stays near 12 A for so many reversals that it never ends by itself.
constexpr const char* kStrong =
    R"({"name": "strong", "task": "two_intervals", "level": "current_percent",
        "question": "Which one was stronger?", "start": 150, "ceiling": 200,
        "stages": [{"step_up": 0.1, "reversals": 50}], "duration_ms": 300, "gap_ms": 200,
        "practice": 0})";
const std::vector<std::string> kRun{"run", "quick", "--participant", "P01", "--simulated"};

TEST_F(Study, ABallThatCannotPlayAllOfAnExperimentIsReportedBeforeItBegins) {
  home_.configure(R"({"limits": {"current_a": 8}})");
  start_daemon();
  store_address();
  plan("th", "1", quick_path());
  for (const auto& words : {kRun, {"rehearse"}}) {
    const Ended refused = study(words);
    EXPECT_EQ(refused.exit_code, 78);
    EXPECT_THAT(refused.err, HasSubstr("quick goes up to 15 A and this ball plays at most 8 A"));
  }
  EXPECT_TRUE(journal("P01.quick.1.jsonl").empty());
}

TEST_F(Study, AForecastThatIsRefusedEndsTheRunWithOnePause) {
  start_daemon(50);
  store_address();
  home_.write("strong.json", kStrong);
  plan("th", "1", home_.path("strong.json"));
  const std::string name = "P01.strong.1.jsonl";
  const auto running = begin({"run", "strong", "--participant", "P01", "--simulated"});
  ASSERT_TRUE(eventually([&] { return count(journal(name), "answered") > 1; }));
  home_.configure(R"({"limits": {"current_a": 8}})");
  daemon_->signal(SIGHUP);
  const Ended ended = running->wait();
  EXPECT_EQ(ended.exit_code, 75);
  EXPECT_THAT(ended.err, HasSubstr("the ball does not play (current_a"));
  EXPECT_EQ(count(journal(name), "paused"), 1);
  EXPECT_EQ(count(journal(name), "continued"), 0);
}

TEST_F(Study, LateAnswersRepeatTheTrialAndAreNoFaultOfTheBall) {
  start_daemon();
  store_address();
  // Simulated people take at least 350 ms: with the first limit half of all answers are late, with
  // the second all.
  home_.write("hasty.json", quick(R"(, "response_limit_ms": 600)"));
  home_.write("never.json", quick(R"(, "response_limit_ms": 300)"));
  plan("th", "1", home_.path("hasty.json"));
  plan("never", "1", home_.path("never.json"));
  const Ended rehearsed = study({"rehearse"});
  EXPECT_EQ(rehearsed.exit_code, 0) << rehearsed.err;
  EXPECT_GT(count(journal("P01.quick.1.jsonl"), "voided"), 5);
  for (const char* verb : {"rehearse", "resume"}) {
    const Ended stuck = study({verb}, "never");
    EXPECT_EQ(stuck.exit_code, 75) << verb;
    EXPECT_EQ(stuck.err,
              "hedgehog-study: no answer in time, again and again (response_limit_ms is 300); "
              "hedgehog-study resume goes on\n")
        << verb;
  }
}

TEST_F(Study, ARunStaysWithItsBall) {
  start_daemon(2);
  store_address();
  plan("th", "1", quick_path());
  const std::string name = "P01.quick.1.jsonl";
  {
    const auto running = begin(kRun);
    ASSERT_TRUE(eventually([&] { return count(journal(name), "answered") > 1; }));
    // While it waits for its ball, another ball is connected.
    home_.configure(R"({"device": "other"})");
    home_.write("config/hedgehog/devices.d/other.json", R"({"name": "other-ball"})");
    daemon_->stop(SIGKILL);
    start_daemon(20);
    ASSERT_TRUE(eventually([&] { return count(journal(name), "paused") == 1; }));
    const auto before = journal(name);
    RawClient hand(daemon_->port());
    const double from = hand.call("ping")["time_ns"];
    ASSERT_TRUE(
        eventually([&] { return hand.call("ping")["time_ns"].get<double>() > from + 20e9; }));
    EXPECT_EQ(journal(name), before);
  }
  const Ended refused = study({"resume"});
  EXPECT_EQ(refused.exit_code, 78);
  EXPECT_THAT(refused.err, HasSubstr("the run was begun on"));
  EXPECT_EQ(study({"rehearse"}).exit_code, 78);
  home_.configure("{}");
  daemon_->stop();
  start_daemon();
  EXPECT_EQ(study({"resume"}).exit_code, 0);
}

TEST_F(Study, ADamagedJournalIsNoUnfinishedRun) {
  start_daemon();
  store_address();
  plan("th", "2", quick_path());
  ASSERT_EQ(study(kRun).exit_code, 0);
  // Killed before its first line was written: nothing is missing.
  home_.write("th/journal/P02.quick.1.jsonl", "");
  EXPECT_EQ(study({"status"}).exit_code, 0);
  const Ended analysed = study({"analyse"});
  EXPECT_EQ(analysed.exit_code, 0);
  EXPECT_THAT(analysed.err, HasSubstr("P02.quick.1.jsonl was killed before it began"));
  EXPECT_EQ(study({"run", "quick", "--participant", "P02", "--simulated"}).exit_code, 0);
  EXPECT_FALSE(journal("P02.quick.2.jsonl").empty());

  std::string text = home_.read("th/journal/P01.quick.1.jsonl");
  const auto last = text.rfind("\"answered\"");
  text.erase(text.find('\n', last) - 3, 3);
  text.erase(text.find('\n', last) + 1);
  home_.write("th/journal/P01.quick.1.jsonl", text);
  for (const char* verb : {"status", "analyse", "export", "resume"}) {
    const Ended ended = study({verb});
    EXPECT_EQ(ended.exit_code, 65) << verb;
    EXPECT_THAT(ended.err, HasSubstr("is damaged")) << verb;
  }
  const Ended another = study({"run", "quick", "--participant", "P01", "--simulated"});
  EXPECT_EQ(another.exit_code, 65);
  EXPECT_THAT(another.err, HasSubstr("is damaged"));
  EXPECT_EQ(home_.read("th/journal/P01.quick.1.jsonl"), text);
}

TEST_F(Study, AmbiguousParticipantsAndRepeatedExperimentsAreRefused) {
  plan("th", "2", quick_path());
  const Ended other = study({"run", "quick", "--participant", "P-01", "--simulated"});
  EXPECT_EQ(other.exit_code, 64);
  EXPECT_THAT(other.err, HasSubstr("P-01 would be taken for P01"));
  for (const std::string& twice :
       {quick_path() + "," + quick_path(), std::string("force-jnd,force-jnd")}) {
    EXPECT_EQ(study({"plan", "again", "--experiments", twice}, "th").exit_code, 64);
    EXPECT_EQ(home_.read("th/again/study.json"), "");
  }
}

TEST_F(Study, AnotherExperimentOfTheSameNameIsRefused) {
  start_daemon();
  store_address();
  plan("th", "2", quick_path());
  ASSERT_EQ(study({"run", "quick", "--participant", "P01", "--simulated"}).exit_code, 0);
  home_.write("changed.json", quick(R"(, "discard": 3)"));
  const std::string changed = home_.path("changed.json");
  const Ended refused = study({"run", changed, "--participant", "P02", "--simulated"});
  EXPECT_EQ(refused.exit_code, 78);
  EXPECT_THAT(refused.err, HasSubstr("give it a name of its own"));
  EXPECT_TRUE(journal("P02.quick.1.jsonl").empty());
  // The same preset under another path is not another experiment.
  EXPECT_EQ(study({"run", quick_path(), "--participant", "P02", "--simulated"}).exit_code, 0);
  std::string preset = quick();
  preset.replace(preset.find("\"quick\""), 7, "\"force-jnd\"");
  home_.write("preset.json", preset);
  const std::string copy = home_.path("preset.json");
  EXPECT_EQ(study({"run", copy, "--participant", "P02", "--simulated"}).exit_code, 78);
  EXPECT_EQ(study({"plan", home_.path("other"), "--experiments", copy}).exit_code, 78);
}

TEST_F(Study, ExitCodesDistinguishErrors) {
  const auto expect_exit = [&](const std::vector<std::string>& words, int code) {
    const Ended ended = study(words);
    EXPECT_EQ(ended.exit_code, code) << words.front() << " " << ended.err;
    EXPECT_NE(ended.err, "");
  };
  EXPECT_EQ(study({"status"}, "nowhere").exit_code, 64);  // -C
  home_.write("bare/nothing", "");
  EXPECT_EQ(study({"status"}, "bare").exit_code, 66);
  plan("th", "1", quick_path());
  expect_exit({"plan", "."}, 73);
  expect_exit({"plan", "new", "--seed", "-1"}, 64);
  expect_exit({"plan", "new", "--seed", "9007199254740993"}, 64);
  expect_exit({"analyse"}, 66);
  expect_exit({"export"}, 66);
  EXPECT_EQ(home_.read("th/data.csv"), "");
  expect_exit({"resume"}, 66);
  expect_exit({"trace", "/tmp", "--responses", "1"}, 66);
  expect_exit({"trace", "force-jnd", "--responses", "1x"}, 65);
  expect_exit({"trace", "nothing", "--responses", "1"}, 64);
  expect_exit({"levels", "--threshold-a", "16"}, 64);
  expect_exit({"levels", "--force-percent", "1e-9"}, 64);
  expect_exit({"simulate", "--observers", "10", "--threads", "-3"}, 64);
  address_ = "127.0.0.1:1";
  expect_exit(kRun, 69);
  start_daemon();
  store_address();
  expect_exit({"run", "quick", "--participant", "P01"}, 64);  // no terminal
}

TEST_F(Study, TracePrintsEverySharedTraceAsJson) {
  std::ifstream file(source_folder() + "/tests/study/data/traces.json");
  const Json shared = Json::parse(file)["traces"];
  ASSERT_EQ(shared.size(), 18U);
  static const char* const kNames[] = {"force-threshold", "force-jnd", "speed-jnd"};
  for (const Json& expected : shared) {
    SCOPED_TRACE(expected["id"].get<std::string>());
    Program program(home_, hedgehog_study(),
                    {"trace", kNames[expected["experiment"].get<int>() - 1], "--responses",
                     expected["responses"], "--json"});
    const Ended ended = program.wait();
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const Json printed = Json::parse(ended.out);
    for (const char* key : {"levels", "reversal_levels", "threshold", "status"})
      EXPECT_EQ(printed[key], expected[key]) << key;
  }
  Program none(home_, hedgehog_study(), {"trace", "force-jnd", "--responses", "", "--json"});
  const Ended ended = none.wait();
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(Json::parse(ended.out)["levels"], Json::array());
  EXPECT_EQ(Json::parse(ended.out)["threshold"], nullptr);
  EXPECT_EQ(Json::parse(ended.out)["status"], "incomplete");
}

}  // namespace
}  // namespace hedgehog::e2e
