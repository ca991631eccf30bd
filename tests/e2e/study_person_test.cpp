// SPDX-License-Identifier: MIT
// hedgehog-study as people use it: at the terminal, from the README, to the report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/e2e/study_fixture.h"

namespace hedgehog::e2e {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(Study, APersonSeesTheQuestionAndNothingElse) {
  start_daemon(20);
  remember_address();
  plan("th", "1", quick_path());
  // The page may be there first, and stays from run to run.
  TerminalProgram page(home_, HEDGEHOG_STUDY_PATH, {"-C", home_.path("th"), "participant"});
  ASSERT_TRUE(page.shows("Please wait."));
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
  ASSERT_TRUE(desk.shows("everybody is ready; c continues"));
  EXPECT_EQ(count(journal("P01.quick.1.jsonl"), "trial_started"), 0);
  desk.type("c");
  ASSERT_TRUE(desk.shows("waiting for the answer"));
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
  // While a note is being typed the run goes on: twenty seconds of the ball's time, two claims'
  // worth, and an answer in the middle of it.
  RawClient game(daemon_->port());
  desk.type("n");
  ASSERT_TRUE(desk.shows("note: "));
  desk.type("coughx\x7f");
  std::this_thread::sleep_for(std::chrono::milliseconds(1000));
  EXPECT_EQ(game.call("effect.pulse", {{"direction", "left"}})["data"]["name"], "claimed");
  page.type("\033[D");
  ASSERT_TRUE(eventually([&] { return count(journal("P01.quick.1.jsonl"), "answered") == 5; }));
  EXPECT_EQ(count(journal("P01.quick.1.jsonl"), "note"), 0);
  desk.type("ed\n");
  ASSERT_TRUE(eventually([&] { return count(journal("P01.quick.1.jsonl"), "note") == 1; }));
  for (const Json& line : journal("P01.quick.1.jsonl")) {
    if (line["event"] == "note") {
      EXPECT_EQ(line["text"], "coughed");
    }
  }
  desk.type("q");
  EXPECT_EQ(desk.wait(), 75);
  EXPECT_TRUE(desk.is_as_a_shell_leaves_it());
  for (const char* secret : {"level", "reversal", "%", "scored", "trial", "P01"}) {
    EXPECT_THAT(page.shown(), testing::Not(HasSubstr(secret)));
  }
  const auto lines = journal("P01.quick.1.jsonl");
  EXPECT_EQ(lines[1]["event"], "checklist");
  EXPECT_EQ(lines[1]["hand_size_cm"], 18.4);
  EXPECT_EQ(lines[1]["consent"], "sheet 014");

  TerminalProgram again(home_, HEDGEHOG_STUDY_PATH, {"-C", home_.path("th"), "resume", "--blind"},
                        variables());
  ASSERT_TRUE(again.shows("headphones"));
  again.type("y\n");
  ASSERT_TRUE(again.shows("dominant hand on top"));
  again.type("y\n");
  ASSERT_TRUE(again.shows("going on"));
  ASSERT_TRUE(again.shows("Your hand on top of the ball, please."));
  again.type("c");
  ASSERT_TRUE(again.shows("Which one was stronger?"));
  ASSERT_TRUE(eventually([&] {
    page.type("\033[D");
    return count(journal("P01.quick.1.jsonl"), "answered") >= 6;
  }));
  EXPECT_EQ(count(journal("P01.quick.1.jsonl"), "checklist"), 2);
  page.type("\003");
  EXPECT_EQ(page.wait(), 0);
  again.type("q");
  EXPECT_EQ(again.wait(), 75);
  for (const char* secret : {"level", "trial", "scored", "kept", "reversal", "%"}) {
    EXPECT_THAT(again.shown(), testing::Not(HasSubstr(secret)));
  }
}

TEST_F(Study, AnotherExperimentOfTheSameNameIsRefused) {
  start_daemon();
  remember_address();
  plan("th", "2", quick_path());
  ASSERT_EQ(study({"run", "quick", "--participant", "P01", "--simulated"}).exit_code, 0);
  home_.write("changed.json", quick(R"(, "discard": 3)"));
  const std::string changed = home_.path("changed.json");
  const Ended refused = study({"run", changed, "--participant", "P02", "--simulated"});
  EXPECT_EQ(refused.exit_code, 78);
  EXPECT_THAT(refused.err, HasSubstr("give it a name of its own"));
  EXPECT_TRUE(journal("P02.quick.1.jsonl").empty());
  // The same under another path is no other one.
  EXPECT_EQ(study({"run", quick_path(), "--participant", "P02", "--simulated"}).exit_code, 0);
  std::string preset = quick();
  preset.replace(preset.find("\"quick\""), 7, "\"force-jnd\"");
  home_.write("preset.json", preset);
  const std::string copy = home_.path("preset.json");
  EXPECT_EQ(study({"run", copy, "--participant", "P02", "--simulated"}).exit_code, 78);
  EXPECT_EQ(study({"plan", home_.path("other"), "--experiments", copy}).exit_code, 78);
}

TEST_F(Study, APersonMayBeSlowRestAndPause) {
  start_daemon(20);
  remember_address();
  home_.write("slow.json", quick(R"(, "response_limit_ms": 200, "rest_every": 1)"));
  plan("th", "1", home_.path("slow.json"));
  TerminalProgram desk(
      home_, HEDGEHOG_STUDY_PATH,
      {"-C", home_.path("th"), "run", "quick", "--participant", "P01", "--experimenter", "E1",
       "--consent", "014", "--age-band", "22-29", "--dominant-hand", "left", "--hand-size", "18.4",
       "--headphones", "--hand-on-top"},
      variables());
  ASSERT_TRUE(desk.shows("c continues"));
  desk.type("c");
  // Nobody answers: void, and the same level again.
  const std::string name = "P01.quick.1.jsonl";
  ASSERT_TRUE(eventually([&] { return count(journal(name), "trial_started") >= 3; }));
  std::vector<Json> trials;
  for (const Json& line : journal(name)) {
    if (line["event"] == "trial_started") {
      trials.push_back(line);
    } else if (line["event"] == "voided") {
      EXPECT_EQ(line["reason"], "no answer in time");
    }
  }
  EXPECT_EQ(trials[1]["attempt"], 2);
  EXPECT_EQ(trials[1]["level"], trials[0]["level"]);
  // Practice and one scored trial are answered; then it is time for a rest.
  const auto scored = [&] {
    int answers = 0;
    bool is_scored = false;
    for (const Json& line : journal(name)) {
      is_scored = line["event"] == "trial_started" ? line["kind"] == "scored" : is_scored;
      answers += is_scored && line["event"] == "answered" ? 1 : 0;
    }
    return answers;
  };
  ASSERT_TRUE(eventually([&] {
    desk.type("\033[C");
    return scored() == 1;
  }));
  ASSERT_TRUE(desk.shows("REST"));
  desk.type("p");
  desk.type("c");
  ASSERT_TRUE(eventually([&] { return count(journal(name), "continued") >= 2; }));
  desk.type("q");
  EXPECT_EQ(desk.wait(), 75);
  EXPECT_EQ(count(journal(name), "rest"), 1);
}

TEST_F(Study, AnalysesAndExportsWhatWasMeasured) {
  start_daemon();
  remember_address();
  plan("th", "2", quick_path() + "," + home_.path("quick-yes-no.json"));
  ASSERT_EQ(study({"rehearse"}).exit_code, 0);
  const Ended analysed = study({"analyse", "--bootstraps", "50"});
  ASSERT_EQ(analysed.exit_code, 0) << analysed.err;
  EXPECT_THAT(analysed.out, HasSubstr("n = 2"));
  EXPECT_THAT(analysed.err, HasSubstr("4 of 4 runs are of simulated people"));
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
  const Json beside = Json::parse(home_.read("th/data.csv.json"));
  ASSERT_EQ(beside.size(), 4U);
  EXPECT_EQ(beside[0]["Participant"], "P01");
  EXPECT_EQ(beside[0]["SimulatedPerson"], true);
  const Json sidecar =
      Json::parse(home_.read("th/bids/sub-P01/beh/sub-P01_task-quick_run-1_beh.json"));
  EXPECT_EQ(sidecar["Protocol"]["name"], "quick");
  EXPECT_EQ(sidecar["Device"]["simulated"], true);
  EXPECT_THAT(home_.read("th/bids/sub-P02/beh/sub-P02_task-quickyesno_run-1_beh.tsv"),
              HasSubstr("\tcatch\t"));
}

TEST_F(Study, TheLinesOfItsReadmeRun) {
  start_daemon();
  remember_address();
  std::ifstream text(std::string(HEDGEHOG_SOURCE_DIR) + "/clients/study/README.md");
  std::string folder = home_.path("");
  int ran = 0;
  const std::string program = "hedgehog-study ";
  for (std::string line; std::getline(text, line);) {
    const auto begin = line.find_first_not_of(' ');
    if (begin == std::string::npos || begin < 4) {
      continue;
    }
    line.erase(0, begin);
    if (line.rfind("cd ", 0) == 0) {
      folder = home_.path(line.substr(3));
      continue;
    }
    if (line.rfind(program, 0) != 0) {
      continue;
    }
    std::vector<std::string> words{"-C", folder};
    std::istringstream rest(line.substr(program.size()));
    for (std::string word; rest >> word;) {
      // Fewer simulated people than the README has: their numbers have tests of their own.
      words.push_back(word == "2000" ? "50" : word);
    }
    // The rehearsal's folder stands in the study's; a person is replaced, the whole study skipped.
    const auto has = [&](const char* word) {
      return std::find(words.begin(), words.end(), word) != words.end();
    };
    if (has("rehearse") || (has("analyse") && has("rehearsal"))) {
      continue;
    }
    if (has("run")) {
      words.emplace_back("--simulated");
    }
    Program command(home_, HEDGEHOG_STUDY_PATH, words, variables());
    const Ended ended = command.wait();
    EXPECT_EQ(ended.exit_code, 0) << line << "\n" << ended.err;
    ++ran;
  }
  EXPECT_GE(ran, 9);
}

}  // namespace
}  // namespace hedgehog::e2e
