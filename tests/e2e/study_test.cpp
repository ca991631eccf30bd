// SPDX-License-Identifier: MIT
// hedgehog-study with a real daemon, a hundred times as fast: timed by the device, alone with the
// ball, and nothing lost whatever is killed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <thread>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr double kMs = 1e6;

/// The question of experiment 2 with short circles and few reversals.
std::string quick(const std::string& more = "") {
  return R"({"name": "quick", "task": "two_intervals", "level": "current_percent",
             "question": "Which one was stronger?", "start": 100, "ceiling": 200,
             "stages": [{"step_up": 20, "reversals": 3}, {"step_up": 10, "reversals": 3}],
             "step_ratio": 0.5488, "duration_ms": 300, "gap_ms": 200, "practice": 1)" +
         more + "}";
}
/// The question of experiment 1.
constexpr const char* kQuickYesNo =
    R"({"name": "quick-yes-no", "task": "yes_no", "level": "current_a", "question": "Felt it?",
        "start": 5, "ceiling": 15, "stages": [{"step_up": 1, "reversals": 5}], "step_ratio": 0.5488,
        "duration_ms": 300, "practice": 0, "catch_one_in": 4})";

class Study : public testing::Test {
 protected:
  Study() {
    home_.write("quick.json", quick());
    home_.write("quick-yes-no.json", kQuickYesNo);
  }
  void start_daemon(int speed = 100) {
    daemon_ = std::make_unique<DaemonProcess>(
        home_, std::vector<std::string>{"--speed", std::to_string(speed)});
  }
  std::vector<std::string> variables() const { return {"HEDGEHOG_ADDRESS=" + address_}; }
  /// The daemon's socket is in the home's runtime directory, also of the one that comes after it.
  void remember_address() { address_ = daemon_->socket(); }

  std::unique_ptr<Program> begin(std::vector<std::string> words, const std::string& folder = "th") {
    words.insert(words.begin(), {"-C", home_.path(folder)});
    return std::make_unique<Program>(home_, HEDGEHOG_STUDY_PATH, words, variables());
  }
  Ended study(const std::vector<std::string>& words, const std::string& folder = "th") {
    return begin(words, folder)->wait();
  }
  void plan(const std::string& folder, const std::string& people, const std::string& experiments) {
    Program program(home_, HEDGEHOG_STUDY_PATH,
                    {"plan", home_.path(folder), "--participants", people, "--experiments",
                     experiments, "--seed", "3"});
    const Ended ended = program.wait();
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
  }
  std::string quick_path() const { return home_.path("quick.json"); }
  std::vector<Json> journal(const std::string& name, const std::string& folder = "th") const {
    std::vector<Json> lines;
    std::istringstream text(home_.read(folder + "/journal/" + name));
    for (std::string line; std::getline(text, line);) {
      const Json parsed = Json::parse(line, nullptr, false);
      if (parsed.is_object()) {
        lines.push_back(parsed);
      }
    }
    return lines;
  }
  std::map<std::string, Json> thresholds(const std::string& folder) {
    std::map<std::string, Json> found;
    for (const Json& run : Json::parse(study({"status", "--json"}, folder).out)) {
      found[run["participant"].get<std::string>() + " " + run["experiment"].get<std::string>()] =
          run["threshold"];
    }
    return found;
  }
  static int count(const std::vector<Json>& lines, const std::string& event) {
    return static_cast<int>(std::count_if(lines.begin(), lines.end(),
                                          [&](const Json& l) { return l["event"] == event; }));
  }

  Home home_;
  std::unique_ptr<DaemonProcess> daemon_;
  std::string address_;
};

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
  const Ended calm = study({"rehearse"}, "calm");
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
    const Ended ended = runner->wait();
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

TEST_F(Study, APersonSeesTheQuestionAndNothingElse) {
  start_daemon(20);
  remember_address();
  plan("th", "1", quick_path());
  TerminalProgram desk(
      home_, HEDGEHOG_STUDY_PATH,
      {"-C", home_.path("th"), "run", "quick", "--participant", "P01", "--experimenter", "E1",
       "--consent", "sheet 014", "--age-band", "22-29", "--dominant-hand", "right"},
      variables());
  ASSERT_TRUE(desk.shows("in cm:"));
  desk.type("184\n");
  ASSERT_TRUE(desk.shows("between 10 and 30 cm"));
  desk.type("18.4\n");
  ASSERT_TRUE(desk.shows("headphones"));
  desk.type("y\n");
  ASSERT_TRUE(desk.shows("on top of the ball"));
  desk.type("y\n");
  ASSERT_TRUE(desk.shows("waiting for the answer"));
  TerminalProgram page(home_, HEDGEHOG_STUDY_PATH, {"-C", home_.path("th"), "participant"});
  ASSERT_TRUE(page.shows("Which one was stronger?"));
  // Practice, and then scored trials, answered on the page.
  for (int answers = 1; answers <= 4; ++answers) {
    page.type("\033[D");
    ASSERT_TRUE(
        eventually([&] { return count(journal("P01.quick.1.jsonl"), "answered") == answers; }));
    ASSERT_TRUE(eventually(
        [&] { return count(journal("P01.quick.1.jsonl"), "interval") == 2 * (answers + 1); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_TRUE(desk.shows("reversals"));
  desk.type("n");
  ASSERT_TRUE(desk.shows("note: "));
  desk.type("coughed\n");
  ASSERT_TRUE(eventually([&] { return count(journal("P01.quick.1.jsonl"), "note") == 1; }));
  desk.type("q");
  EXPECT_EQ(desk.wait(), 75);
  EXPECT_TRUE(desk.is_as_a_shell_leaves_it());
  EXPECT_EQ(page.wait(), 0);
  for (const char* secret : {"level", "reversal", "%", "scored", "trial", "P01"}) {
    EXPECT_THAT(page.shown(), testing::Not(HasSubstr(secret)));
  }
  const auto lines = journal("P01.quick.1.jsonl");
  EXPECT_EQ(lines[1]["event"], "checklist");
  EXPECT_EQ(lines[1]["hand_size_cm"], 18.4);
  EXPECT_EQ(lines[1]["consent"], "sheet 014");

  TerminalProgram again(home_, HEDGEHOG_STUDY_PATH, {"-C", home_.path("th"), "resume", "--blind"},
                        variables());
  ASSERT_TRUE(again.shows("3 trials kept"));
  ASSERT_TRUE(again.shows("Which one was stronger?"));
  again.type("q");
  EXPECT_EQ(again.wait(), 75);
  const auto after = again.shown().substr(again.shown().find("\033[?1049h"));
  EXPECT_THAT(after, testing::Not(HasSubstr("level")));
}

TEST_F(Study, AnalysesAndExportsWhatWasMeasured) {
  start_daemon();
  remember_address();
  plan("th", "2", quick_path() + "," + home_.path("quick-yes-no.json"));
  ASSERT_EQ(study({"rehearse"}).exit_code, 0);
  const Ended analysed = study({"analyse", "--bootstraps", "50"});
  ASSERT_EQ(analysed.exit_code, 0) << analysed.err;
  EXPECT_THAT(analysed.out, HasSubstr("n = 2"));
  const std::string page = home_.read("th/analysis/report.html");
  EXPECT_THAT(page, HasSubstr("P02, quick"));  // a figure's title
  EXPECT_THAT(page, HasSubstr("about 10"));
  for (const char* figure : {"groups.svg", "groups.png", "P01.quick.1.svg", "P02.quick.1.png"}) {
    EXPECT_GT(fs::file_size(home_.path(std::string("th/analysis/figures/") + figure)), 2000U);
  }
  ASSERT_EQ(study({"export"}).exit_code, 0);
  EXPECT_EQ(study({"export"}).exit_code, 73);
  ASSERT_EQ(study({"export", "--format", "bids"}).exit_code, 0);
  const std::string csv = home_.read("th/data.csv");
  EXPECT_THAT(csv, testing::StartsWith("participant,session,experiment,run,event,scored_trial"));
  const Json sidecar =
      Json::parse(home_.read("th/bids/sub-P01/beh/sub-P01_task-quick_run-1_beh.json"));
  EXPECT_EQ(sidecar["Protocol"]["name"], "quick");
  EXPECT_EQ(sidecar["Device"]["simulated"], true);
  EXPECT_THAT(home_.read("th/bids/sub-P02/beh/sub-P02_task-quickyesno_run-1_beh.tsv"),
              HasSubstr("\tcatch\t"));
}

}  // namespace
}  // namespace hedgehog::e2e
