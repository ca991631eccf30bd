// SPDX-License-Identifier: MIT
// hedgehog-study with a real daemon, a hundred times as fast: timed by the device, alone with the
// ball, and nothing lost whatever is killed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <thread>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/study_fixture.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;

constexpr double kMs = 1e6;

TEST_F(Study, ARunIsTimedByTheDevicesClock) {
  start_daemon();
  remember_address();
  plan("th", "1", quick_path());
  const Ended ended = study({"run", "quick", "--participant", "P01", "--simulated"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("6 reversals"));
  const auto lines = journal("P01.quick.1.jsonl");
  EXPECT_EQ(lines.front()["event"], "run_started");
  EXPECT_EQ(lines.back()["event"], "finished");
  double first_offset = 0;
  double first_current = 0;
  for (const Json& line : lines) {
    if (line["event"] != "interval") {
      continue;
    }
    const double onset = line["onset_ns"];
    const double offset = line["offset_ns"];
    EXPECT_NEAR((offset - onset) / kMs, 300, 3);
    EXPECT_EQ(line["reason"], "completed");
    EXPECT_LE(line["command_ns"], line["ack_ns"]);
    if (line["interval"] == 1) {
      first_offset = offset;
      first_current = line["current_a"];
    } else {
      // At this speed the command may come late; it never comes early.
      EXPECT_GE((onset - first_offset) / kMs, 199);
      EXPECT_EQ(std::min(first_current, line["current_a"].get<double>()), 5);
    }
  }
  EXPECT_EQ(study({"run", "quick", "--participant", "P01", "--simulated"}).exit_code, 73);
  EXPECT_EQ(study({"run", "quick", "--participant", "P01", "--simulated", "--again"}).exit_code, 0);
  EXPECT_EQ(journal("P01.quick.1.jsonl"), lines);
  EXPECT_FALSE(journal("P01.quick.2.jsonl").empty());
}

TEST_F(Study, CatchTrialsPlayNothing) {
  start_daemon();
  remember_address();
  plan("th", "1", home_.path("quick-yes-no.json"));
  ASSERT_EQ(study({"run", "quick-yes-no", "--participant", "P01", "--simulated"}).exit_code, 0);
  std::string kind;
  int catches = 0;
  for (const Json& line : journal("P01.quick-yes-no.1.jsonl")) {
    if (line["event"] == "trial_started") {
      kind = line["kind"];
    } else if (line["event"] == "interval" && kind == "catch") {
      ++catches;
      EXPECT_EQ(line["current_a"], 0);
      EXPECT_NEAR((line["offset_ns"].get<double>() - line["onset_ns"].get<double>()) / kMs, 300, 3);
    }
  }
  EXPECT_GT(catches, 0);
}

TEST_F(Study, ASimulatedAnswerThatIsTooLateIsVoidLikeAPersons) {
  start_daemon();
  remember_address();
  home_.write("hasty.json", quick(R"(, "response_limit_ms": 1000)"));
  plan("th", "1", home_.path("hasty.json"));
  ASSERT_EQ(study({"run", "quick", "--participant", "P01", "--simulated"}).exit_code, 0);
  const auto lines = journal("P01.quick.1.jsonl");
  EXPECT_GE(count(lines, "voided"), 1);
  for (const Json& line : lines) {
    if (line["event"] == "voided") {
      EXPECT_EQ(line["reason"], "no answer in time");
    } else if (line["event"] == "answered") {
      EXPECT_LE(line["response_ms"], 1000);
    }
  }
}

TEST_F(Study, TheBallIsItsAlone) {
  start_daemon(2);
  remember_address();
  plan("th", "1", quick_path());
  RawClient game(daemon_->port());
  {
    RawClient other(daemon_->port());
    ASSERT_FALSE(other.call("device.claim", {{"lease_ms", 10000}}).contains("code"));
    const Ended refused = study({"run", "quick", "--participant", "P01", "--simulated"});
    EXPECT_EQ(refused.exit_code, 75) << refused.err;
    EXPECT_TRUE(journal("P01.quick.1.jsonl").empty());
  }
  const auto running = begin({"run", "quick", "--participant", "P01", "--simulated"});
  ASSERT_TRUE(eventually([&] { return count(journal("P01.quick.1.jsonl"), "answered") > 0; }));
  EXPECT_EQ(game.call("effect.pulse", {{"direction", "left"}})["data"]["name"], "claimed");
  running->signal(SIGTERM);
  const Ended stopped = running->wait();
  EXPECT_EQ(stopped.exit_code, 130);
  EXPECT_EQ(journal("P01.quick.1.jsonl").back()["event"], "stopped");
  EXPECT_EQ(study({"run", "quick", "--participant", "P01", "--simulated"}).exit_code, 75);
  // The ball is free again.
  EXPECT_FALSE(game.call("effect.pulse", {{"direction", "left"}}).contains("code"));
}

TEST_F(Study, AnEmergencyStopVoidsTheTrialAndPausesUntilTheBallIsArmed) {
  start_daemon(20);
  remember_address();
  plan("th", "1", quick_path());
  RawClient hand(daemon_->port());
  const auto running = begin({"run", "quick", "--participant", "P01", "--simulated"});
  ASSERT_TRUE(eventually([&] { return count(journal("P01.quick.1.jsonl"), "answered") > 1; }));
  hand.call("device.emergency_stop");
  ASSERT_TRUE(eventually([&] { return count(journal("P01.quick.1.jsonl"), "paused") == 1; }));
  EXPECT_FALSE(hand.call("device.arm").contains("code"));
  EXPECT_EQ(running->wait().exit_code, 0);
  const auto lines = journal("P01.quick.1.jsonl");
  EXPECT_LE(count(lines, "voided"), 1);
  EXPECT_EQ(count(lines, "continued"), 1);
}

TEST_F(Study, AWarmBallIsLeftToCoolBeforeATrialWouldBeReduced) {
  home_.configure(R"({"simulator": {"start_temperature_c": 66}})");
  start_daemon();
  remember_address();
  // 10 A at the start level; at 66 °C the law allows 7.
  plan("th", "1", quick_path());
  ASSERT_EQ(study({"run", "quick", "--participant", "P01", "--simulated"}).exit_code, 0);
  const auto lines = journal("P01.quick.1.jsonl");
  EXPECT_GE(count(lines, "paused"), 1);
  EXPECT_EQ(count(lines, "paused"), count(lines, "continued"));
  EXPECT_EQ(count(lines, "voided"), 0);
  for (const Json& line : lines) {
    if (line["event"] == "paused") {
      EXPECT_THAT(line["text"].get<std::string>(), HasSubstr("would be reduced"));
    }
  }
}

TEST_F(Study, KilledAtAnyMomentItEndsWithTheSameThresholds) {
  // HEDGEHOG_STUDY_KILLS=20 HEDGEHOG_STUDY_WHOLE=1: ten people, the three experiments; minutes.
  const char* many = std::getenv("HEDGEHOG_STUDY_KILLS");
  const int kills = many != nullptr ? std::atoi(many) : 6;
  const bool whole = std::getenv("HEDGEHOG_STUDY_WHOLE") != nullptr;
  const std::string people = whole ? "10" : "3";
  const std::string experiments = whole ? "force-threshold,force-jnd,speed-jnd"
                                        : quick_path() + "," + home_.path("quick-yes-no.json");
  start_daemon();
  remember_address();
  plan("calm", people, experiments);
  plan("shaken", people, experiments);
  const Ended calm = patiently(*begin({"rehearse"}, "calm"));
  ASSERT_EQ(calm.exit_code, 0) << calm.err;
  const auto expected = thresholds("calm");
  ASSERT_EQ(expected.size(), whole ? 30U : 6U);

  std::mt19937 random(5);  // NOLINT(cert-msc51-cpp): the same moments each time
  auto runner = begin({"rehearse"}, "shaken");
  for (int kill = 0; kill < kills; ++kill) {
    std::this_thread::sleep_for(std::chrono::milliseconds(
        std::uniform_int_distribution<int>(20, whole ? 8000 : 250)(random)));
    if (kill % 2 == 0) {
      runner = nullptr;  // SIGKILL
      runner = begin({"rehearse"}, "shaken");
    } else {
      daemon_->stop(SIGKILL);
      start_daemon();
    }
  }
  while (true) {
    const Ended ended = patiently(*runner);
    ASSERT_NE(ended.exit_code, -1);
    if (ended.exit_code == 0) {
      break;
    }
    runner = begin({"rehearse"}, "shaken");
  }
  EXPECT_EQ(thresholds("shaken"), expected);
  for (const auto& [run, threshold] : expected) {
    EXPECT_TRUE(threshold.is_string()) << run;
  }
}

}  // namespace
}  // namespace hedgehog::e2e
