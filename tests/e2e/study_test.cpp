// SPDX-License-Identifier: MIT
// hedgehog-study with a real daemon at up to a hundred times real time: timed by the device, with
// an exclusive claim on the ball, and without data loss whichever process is killed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "tests/e2e/busy_machine.h"
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
  store_address();
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
    if (line["event"] != "interval") continue;
    const double onset = line["onset_ns"];
    const double offset = line["offset_ns"];
    EXPECT_NEAR((offset - onset) / kMs, 300, 3);
    EXPECT_EQ(line["reason"], "completed");
    EXPECT_LE(line["command_ns"], line["ack_ns"]);
    if (line["interval"] == 1) {
      first_offset = offset;
      first_current = line["current_a"];
    } else {
      // At this speed the command may be late; it is never early.
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
  store_address();
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

TEST_F(Study, ALateSimulatedAnswerIsVoidAsAPersonsIs) {
  start_daemon();
  store_address();
  home_.write("hasty.json", quick(R"(, "response_limit_ms": 1000)"));
  plan("th", "1", home_.path("hasty.json"));
  ASSERT_EQ(study({"run", "quick", "--participant", "P01", "--simulated"}).exit_code, 0);
  const auto lines = journal("P01.quick.1.jsonl");
  EXPECT_GE(count(lines, "voided"), 1);
  for (const Json& line : lines)
    if (line["event"] == "voided")
      EXPECT_EQ(line["reason"], "no answer in time");
    else if (line["event"] == "answered")
      EXPECT_LE(line["response_ms"], 1000);
}

TEST_F(Study, TheBallIsClaimed) {
  start_daemon(2);
  store_address();
  plan("th", "1", quick_path());
  RawClient game(daemon_->port());
  {
    RawClient other(daemon_->port());
    const auto claim = [&] {
      EXPECT_FALSE(other.call("device.claim", {{"lease_ms", 10000}}).contains("code"));
    };
    claim();
    const auto without_ball = begin({"run", "quick", "--participant", "P01", "--simulated"});
    const Ended refused = wait_renewing(*without_ball, claim);
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
  start_daemon(2);
  store_address();
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

TEST_F(Study, AnUnpluggedBallVoidsTheTrialAndPausesUntilItReturns) {
  start_daemon(2);
  store_address();
  plan("th", "1", quick_path());
  const std::string name = "P01.quick.1.jsonl";
  RawClient hand(daemon_->port());
  const auto running = begin({"run", "quick", "--participant", "P01", "--simulated"});
  // During a trial.
  ASSERT_TRUE(eventually([&] {
    const auto lines = journal(name);
    return count(lines, "answered") > 1 && lines.back()["event"] == "trial_started";
  }));
  hand.call("sim.set", {{"fault", {{"faults", {"silent"}}}}});
  ASSERT_TRUE(eventually([&] { return count(journal(name), "paused") == 1; }));
  EXPECT_EQ(hand.call("device.status")["state"], "absent");
  const int answered = count(journal(name), "answered");
  hand.call("sim.set", {{"fault", {{"faults", Json::array()}}}});
  // As after plugging in: disarmed until a client arms it.
  ASSERT_TRUE(eventually([&] { return !hand.call("device.arm").contains("code"); }));
  EXPECT_EQ(running->wait().exit_code, 0);
  const auto lines = journal(name);
  EXPECT_GT(count(lines, "answered"), answered);
  EXPECT_LE(count(lines, "voided"), 1);
  EXPECT_EQ(count(lines, "paused"), count(lines, "continued"));
  EXPECT_THAT(lines, testing::Contains(testing::ResultOf(
                         [](const Json& line) { return line.value("text", std::string()); },
                         HasSubstr("the ball is absent"))));
}

TEST_F(Study, AWarmBallCoolsBeforeATrialWouldBeReduced) {
  // 10 A at the start level; from about 40 °C on the skin limit allows less. In a room of 42 °C it
  // always does, however late the first trial is.
  home_.configure(R"({"simulator": {"start_temperature_c": 42, "ambient_c": 42}})");
  plan("th", "1", quick_path());
  start_daemon(10);
  store_address();
  RawClient hand(daemon_->port());
  const auto running = begin({"run", "quick", "--participant", "P01", "--simulated"});
  ASSERT_TRUE(eventually([&] { return count(journal("P01.quick.1.jsonl"), "paused") == 1; }));
  hand.call("sim.set", {{"ambient_c", 20}});
  ASSERT_EQ(running->wait().exit_code, 0);
  const auto lines = journal("P01.quick.1.jsonl");
  EXPECT_GE(count(lines, "paused"), 1);
  EXPECT_EQ(count(lines, "paused"), count(lines, "continued"));
  EXPECT_EQ(count(lines, "voided"), 0);
  for (const Json& line : lines)
    if (line["event"] == "paused")
      EXPECT_THAT(line["text"].get<std::string>(), HasSubstr("would be reduced"));
}

}  // namespace
}  // namespace hedgehog::e2e
