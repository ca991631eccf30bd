// SPDX-License-Identifier: MIT
// hedgehog-study in practice: at the terminal, from the README to the report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/e2e/busy_machine.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/study_fixture.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;

/// How many times the question was shown.
int questions_shown(TerminalProgram& page) {
  const std::string question = "Which one was stronger?";
  page.shows(question);
  int times = 0;
  for (auto at = page.shown().find(question); at != std::string::npos;
       at = page.shown().find(question, at + 1))
    ++times;
  return times;
}

TEST_F(Study, APersonSeesTheQuestionAndNothingElse) {
  // Slow, because a claim lasts ten seconds of the ball's time.
  start_daemon(2);
  store_address();
  plan("th", "1", quick_path());
  // The page may start first, and stays open from run to run.
  TerminalProgram page(home_, hedgehog_study(), {"-C", home_.path("th"), "participant"});
  ASSERT_TRUE(page.shows("Please wait."));
  TerminalProgram desk(
      home_, hedgehog_study(),
      {"-C", home_.path("th"), "run", "quick", "--participant", "P01", "--experimenter", "E1",
       "--consent", "sheet 014", "--age-band", "22-29", "--dominant-hand", "right"},
      variables());
  ASSERT_TRUE(desk.shows("in cm:"));
  desk.type("184\n");
  ASSERT_TRUE(desk.shows("between 10 and 30 cm"));
  desk.type("18,4\n");
  ASSERT_TRUE(desk.shows("write 18,4 with a point, 18.4"));
  desk.type("18.4\n");
  ASSERT_TRUE(desk.shows("headphones"));
  desk.type("u\n");
  ASSERT_TRUE(desk.shows("y or n, please"));
  desk.type("y\n");
  ASSERT_TRUE(desk.shows("on top of the ball"));
  desk.type("y\n");
  ASSERT_TRUE(desk.shows("everybody is ready; c continues"));
  EXPECT_EQ(count(journal("P01.quick.1.jsonl"), "trial_started"), 0);
  desk.type("c");
  ASSERT_TRUE(desk.shows("waiting for the answer"));
  ASSERT_TRUE(page.shows("Which one was stronger?"));
  // Practice and then scored trials are answered on the page.
  for (int answers = 1; answers <= 4; ++answers) {
    page.type("\033[D");
    ASSERT_TRUE(
        eventually([&] { return count(journal("P01.quick.1.jsonl"), "answered") == answers; }));
    ASSERT_TRUE(eventually([&] { return questions_shown(page) == answers + 1; }));
  }
  EXPECT_TRUE(desk.shows("reversals"));
  // While a note is being typed the run continues: for twenty seconds of the ball's time, the
  // duration of two claims, with an answer in between.
  RawClient game(daemon_->port());
  desk.type("n");
  ASSERT_TRUE(desk.shows("note: "));
  desk.type("coughx\x7f");
  const double start_ns = game.call("ping")["time_ns"];
  ASSERT_TRUE(
      eventually([&] { return game.call("ping")["time_ns"].get<double>() > start_ns + 20e9; }));
  EXPECT_EQ(game.call("effect.pulse", {{"direction", "left"}})["data"]["name"], "claimed");
  page.type("\033[D");
  ASSERT_TRUE(eventually([&] { return count(journal("P01.quick.1.jsonl"), "answered") == 5; }));
  EXPECT_EQ(count(journal("P01.quick.1.jsonl"), "note"), 0);
  desk.type("ed\n");
  ASSERT_TRUE(eventually([&] { return count(journal("P01.quick.1.jsonl"), "note") == 1; }));
  for (const Json& line : journal("P01.quick.1.jsonl"))
    if (line["event"] == "note") EXPECT_EQ(line["text"], "coughed");
  desk.type("q");
  EXPECT_EQ(desk.wait(), 75);
  EXPECT_TRUE(desk.is_restored());
  for (const char* secret : {"level", "reversal", "%", "scored", "trial", "P01"})
    EXPECT_THAT(page.shown(), testing::Not(HasSubstr(secret)));
  const auto lines = journal("P01.quick.1.jsonl");
  EXPECT_EQ(lines[1]["event"], "checklist");
  EXPECT_EQ(lines[1]["hand_size_cm"], 18.4);
  EXPECT_EQ(lines[1]["consent"], "sheet 014");

  TerminalProgram again(home_, hedgehog_study(), {"-C", home_.path("th"), "resume", "--blind"},
                        variables());
  ASSERT_TRUE(again.shows("headphones"));
  again.type("y\n");
  ASSERT_TRUE(again.shows("dominant hand on top"));
  again.type("y\n");
  ASSERT_TRUE(again.shows("going on"));
  ASSERT_TRUE(again.shows("Your hand on top of the ball, please."));
  ASSERT_TRUE(again.shows("c begins"));
  again.type("c");
  ASSERT_TRUE(again.shows("Which one was stronger?"));
  ASSERT_TRUE(type_until(page, "\033[D",
                         [&] { return count(journal("P01.quick.1.jsonl"), "answered") >= 6; }));
  EXPECT_EQ(count(journal("P01.quick.1.jsonl"), "checklist"), 2);
  page.type("\003");
  EXPECT_EQ(page.wait(), 0);
  again.type("q");
  EXPECT_EQ(again.wait(), 75);
  // A blind session resumed without --blind stays blind.
  TerminalProgram third(home_, hedgehog_study(), {"-C", home_.path("th"), "resume"}, variables());
  ASSERT_TRUE(third.shows("headphones"));
  third.type("y\ny\n");
  ASSERT_TRUE(third.shows("c begins"));
  third.type("q");
  EXPECT_EQ(third.wait(), 75);
  EXPECT_THAT(third.shown(), testing::Not(HasSubstr("level")));
  for (const char* secret : {"level", "trial", "scored", "kept", "reversal", "%"})
    EXPECT_THAT(again.shown(), testing::Not(HasSubstr(secret)));
}

TEST_F(Study, ADaemonThatEndsDuringAQuestionLosesNoAnswer) {
  start_daemon(20);
  store_address();
  plan("th", "1", quick_path());
  const std::string name = "P01.quick.1.jsonl";
  TerminalProgram desk(home_, hedgehog_study(), run_quick(), variables());
  ASSERT_TRUE(desk.shows("c continues"));
  desk.type("c");
  ASSERT_TRUE(desk.shows("waiting for the answer"));
  daemon_->stop(SIGKILL);
  desk.type("\033[D");
  ASSERT_TRUE(desk.shows("waiting for the ball"));
  EXPECT_EQ(count(journal(name), "answered"), 1);
  start_daemon(20);
  // A restarted daemon may have another ball: nothing is played without the experimenter's
  // confirmation.
  ASSERT_TRUE(desk.shows("was restarted"));
  EXPECT_EQ(count(journal(name), "daemon_changed"), 0);
  EXPECT_EQ(count(journal(name), "trial_started"), 1);
  desk.type("c");
  ASSERT_TRUE(eventually([&] { return count(journal(name), "daemon_changed") == 1; }));
  const auto answers = [&](int wanted) {
    return type_until(desk, "\033[D", [&] { return count(journal(name), "answered") >= wanted; });
  };
  ASSERT_TRUE(answers(3));
  // Once, and not again for the earlier loss; the trial that was played stays valid.
  const auto lines = journal(name);
  EXPECT_EQ(count(lines, "paused"), 2);
  EXPECT_EQ(count(lines, "continued"), 2);
  EXPECT_EQ(count(lines, "voided"), 0);
  desk.type("q");
  EXPECT_EQ(desk.wait(), 75);
}

TEST_F(Study, APersonMayBeSlowRestAndPause) {
  start_daemon(20);
  store_address();
  home_.write("slow.json", quick(R"(, "response_limit_ms": 5000, "rest_every": 1)"));
  plan("th", "1", home_.path("slow.json"));
  TerminalProgram desk(home_, hedgehog_study(), run_quick(), variables());
  ASSERT_TRUE(desk.shows("c continues"));
  desk.type("c");
  // Without an answer: the trial is void, and the level is repeated.
  const std::string name = "P01.quick.1.jsonl";
  ASSERT_TRUE(eventually([&] { return count(journal(name), "trial_started") >= 3; }));
  std::vector<Json> trials;
  for (const Json& line : journal(name))
    if (line["event"] == "trial_started")
      trials.push_back(line);
    else if (line["event"] == "voided")
      EXPECT_EQ(line["reason"], "no answer in time");
  EXPECT_EQ(trials[1]["attempt"], 2);
  EXPECT_EQ(trials[1]["level"], trials[0]["level"]);
  // Practice and one scored trial are answered; then a rest is due.
  const auto scored = [&] {
    int answers = 0;
    bool is_scored = false;
    for (const Json& line : journal(name)) {
      is_scored = line["event"] == "trial_started" ? line["kind"] == "scored" : is_scored;
      answers += is_scored && line["event"] == "answered" ? 1 : 0;
    }
    return answers;
  };
  ASSERT_TRUE(type_until(desk, "\033[C", [&] { return scored() == 1; }));
  ASSERT_TRUE(desk.shows("REST"));
  desk.type("p");
  desk.type("c");
  ASSERT_TRUE(eventually([&] { return count(journal(name), "continued") >= 2; }));
  desk.type("q");
  EXPECT_EQ(desk.wait(), 75);
  EXPECT_EQ(count(journal(name), "rest"), 1);
}

TEST_F(Study, AKeyPressedBeforeTheQuestionIsIgnored) {
  start_daemon(2);
  store_address();
  std::string slow = quick();
  slow.replace(slow.find("300"), 3, "9000");
  home_.write("slow.json", slow);
  plan("th", "1", home_.path("slow.json"));
  const std::string name = "P01.quick.1.jsonl";
  TerminalProgram page(home_, hedgehog_study(), {"-C", home_.path("th"), "participant"});
  TerminalProgram desk(home_, hedgehog_study(), run_quick(), variables());
  ASSERT_TRUE(desk.shows("c continues"));
  ASSERT_TRUE(page.shows("Your hand"));
  desk.type("c");
  ASSERT_TRUE(page.shows("Feel: the second."));
  // Both programs are stopped, as by a slow disk, until the second circle is over.
  desk.signal(SIGSTOP);
  page.signal(SIGSTOP);
  desk.type("\033[D");
  page.type("\033[D");
  RawClient hand(daemon_->port());
  const double from = hand.call("ping")["time_ns"];
  ASSERT_TRUE(eventually([&] { return hand.call("ping")["time_ns"].get<double>() > from + 10e9; }));
  desk.signal(SIGCONT);
  ASSERT_TRUE(desk.shows("waiting for the answer"));
  page.signal(SIGCONT);
  ASSERT_TRUE(page.shows("Which one was stronger?"));
  // A key that the page did pass on would be in the journal long before this one.
  page.type("v");
  ASSERT_TRUE(eventually([&] { return hand.call("ping")["time_ns"].get<double>() > from + 13e9; }));
  EXPECT_EQ(count(journal(name), "answered"), 0);
  page.type("\033[D");
  ASSERT_TRUE(eventually([&] { return count(journal(name), "answered") == 1; }));
  desk.type("q");
  EXPECT_EQ(desk.wait(), 75);
}

}  // namespace
}  // namespace hedgehog::e2e
