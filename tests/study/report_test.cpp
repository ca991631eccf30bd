// SPDX-License-Identifier: MIT
// What comes out: rows, files, pages; and which intervals make a trial void.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <map>

#include "clients/study/experiment_file.h"
#include "clients/study/journal/journal.h"
#include "clients/study/report/bids.h"
#include "clients/study/report/collect.h"
#include "clients/study/report/figures.h"
#include "clients/study/report/rows.h"
#include "clients/study/session/player.h"
#include "clients/study/session/screen.h"

namespace hedgehog::study {
namespace {

using testing::HasSubstr;

IntervalPlayed good(int interval, double current_a) {
  const std::int64_t onset = 1'000'000'000LL * (1 + 6 * interval);
  return {interval,
          {current_a, 10},
          onset - 500'000'000,
          onset - 499'000'000,
          onset,
          onset + 5'000'000'000,
          "completed",
          1.0,
          1.0,
          0,
          0,
          current_a,
          30.0};
}

/// Practice, a right answer, a void, a wrong answer.
RecordedRun recorded() {
  RunStarted header;
  header.participant = "P01";
  header.experiment = find_experiment("force-jnd").value();
  header.experiment.practice = 1;
  header.seeds = {7, 8};
  header.software_version = "0.1.0";
  std::vector<Line> lines{{1, "t", header}};
  const auto put = [&](const Event& event) {
    lines.push_back({static_cast<std::int64_t>(lines.size()) + 1, "t", event});
  };
  for (const char* what : {"right", "right", "void", "wrong"}) {
    const Trial trial = *RecordedRun::replay(lines).value().state().next();
    const bool first = trial.interval_of_test == 1;
    put(TrialStarted{trial});
    put(good(1, first ? 10 : 5));
    put(good(2, first ? 5 : 10));
    if (std::string(what) == "void") {
      put(Voided{"a comma, and a \"quote\""});
    } else {
      put(Answered{first == (std::string(what) == "right") ? Answer::kFirst : Answer::kSecond,
                   640});
    }
  }
  return RecordedRun::replay(lines).value();
}

std::map<std::string, std::string> named(const std::vector<std::string>& row) {
  std::map<std::string, std::string> cells;
  for (std::size_t i = 0; i < row.size(); ++i) {
    cells[columns()[i].name] = row[i];
  }
  return cells;
}

TEST(Rows, AreOneForEachPresentationBlock) {
  const auto rows = rows_of(recorded());
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), columns().size());
  }
  EXPECT_EQ(columns().size(), 33U);
  auto practice = named(rows[0]);
  EXPECT_EQ(practice["kind"], "practice");
  EXPECT_EQ(practice["included"], "0");
  EXPECT_EQ(practice["scored_trial"], "n/a");
  auto right = named(rows[1]);
  EXPECT_EQ(right["kind"], "scored");
  EXPECT_EQ(right["included"], "1");
  EXPECT_EQ(right["level_nominal"], "100");
  EXPECT_EQ(right["level_presented"], "100");
  EXPECT_EQ(right["current_commanded_A"], "10");
  EXPECT_EQ(right["correct"], "1");
  EXPECT_EQ(right["move"], "down");
  EXPECT_EQ(right["response_time"], "0.64");
  EXPECT_EQ(right["duration"], "11");
  EXPECT_EQ(right["t_onset"], "7");
  auto voided = named(rows[2]);
  EXPECT_EQ(voided["kind"], "void");
  EXPECT_EQ(voided["response"], "n/a");
  EXPECT_EQ(voided["level_nominal"], "89.024");
  auto wrong = named(rows[3]);
  EXPECT_EQ(wrong["correct"], "0");
  EXPECT_EQ(wrong["move"], "up");
  EXPECT_EQ(wrong["reversal"], "1");
  EXPECT_EQ(wrong["level_nominal"], "89.024");
}

TEST(Rows, AreQuotedWhereNeeded) {
  EXPECT_EQ(csv_line({"a", "b,c", "d\"e", ""}), "a,\"b,c\",\"d\"\"e\",");
  EXPECT_EQ(tsv_line({"a", "b\tc\nd"}), "a\tb c d");
}

TEST(Sidecar, SaysTheChoicesOfItsOwnExperiment) {
  AnalysedRun run{{"P01", "force-jnd", 1, {}}, recorded(), {}, true};
  const std::string usual = bids_sidecar(run);
  EXPECT_THAT(usual, HasSubstr("one of each until the first reversal, then 2 down, 1 up"));
  EXPECT_THAT(usual, HasSubstr("all reversals but the first 2;"));
  EXPECT_THAT(usual, HasSubstr("\"catch_trials\": \"none\""));
  RunStarted header = run.run.header();
  header.experiment = find_experiment("force-threshold").value();
  header.experiment.rule.quick_start = false;
  header.experiment.rule.positives_down = 3;
  header.experiment.rule.discard = 4;
  run.run = RecordedRun::replay({{1, "t", header}}).value();
  const std::string other = bids_sidecar(run);
  EXPECT_THAT(other, HasSubstr("3 down, 1 up from the start"));
  EXPECT_THAT(other, HasSubstr("all reversals but the first 4;"));
  EXPECT_THAT(other, HasSubstr("one in 6, never first"));
}

TEST(Figure, MarksReversalsAndTheMean) {
  AnalysedRun run{{"P01", "force-jnd", 1, {}}, recorded(), {}, true};
  run.analysis.threshold = 13.25;
  const std::string plot = staircase_plot(run);
  EXPECT_THAT(plot, HasSubstr("1 100 1\n2 89.024 0\nEND"));
  EXPECT_THAT(plot, HasSubstr("$reversals << END\n2 89.024 1\nEND"));
  EXPECT_THAT(plot, HasSubstr("mean of reversals, 13.25 %"));
}

AnalysedRun threshold_of(const std::string& participant, int run, double threshold, bool simulated,
                         int discard = 2) {
  RunStarted header;
  header.participant = participant;
  header.experiment = find_experiment("force-jnd").value();
  header.experiment.rule.discard = discard;
  header.run = run;
  header.simulated_person = simulated;
  AnalysedRun analysed{{participant, "force-jnd", run, {}},
                       RecordedRun::replay({{1, "t", header}}).value(),
                       {},
                       false};
  analysed.analysis.threshold = threshold;
  return analysed;
}

TEST(Groups, HoldTheSameExperimentAndNoProgramsAmongPeople) {
  std::vector<AnalysedRun> runs{threshold_of("P01", 1, 10, false),
                                threshold_of("P01", 2, 12, false), threshold_of("P01", 3, 99, true),
                                threshold_of("P02", 1, 14, false),
                                threshold_of("P03", 1, 50, true, 3)};
  choose(runs);
  const StudyFolder study =
      StudyFolder::create(testing::TempDir() + "/groups-" + std::to_string(::getpid()),
                          make_plan(3, {"force-jnd"}, 1))
          .value();
  const auto groups = groups_of(study, runs);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].result.count, 2);
  EXPECT_EQ(groups[0].result.mean, 13);
  // Another rule under the same name: by itself, and there are no people in it.
  EXPECT_EQ(groups[1].result.count, 1);
  EXPECT_EQ(groups[1].result.mean, 50);
}

TEST(Collect, GivesEachRunReplicationsOfItsOwn) {
  const StudyFolder study =
      StudyFolder::create(testing::TempDir() + "/collect-" + std::to_string(::getpid()),
                          make_plan(2, {"force-jnd"}, 1))
          .value();
  for (const char* participant : {"P01", "P02"}) {
    RunStarted header;
    header.participant = participant;
    header.experiment = find_experiment("force-jnd").value();
    Journal journal =
        Journal::create(study.journal_path(participant, "force-jnd", 1), header).value();
    for (int trial = 0; const auto next = journal.run().state().next(); ++trial) {
      ASSERT_TRUE(journal.append(TrialStarted{*next}));
      const bool right = trial % 3 != 2;
      ASSERT_TRUE(journal.append(Answered{
          (next->interval_of_test == 1) == right ? Answer::kFirst : Answer::kSecond, 500}));
    }
  }
  std::vector<std::string> problems;
  const auto runs = collect(study, 40, problems);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].analysis.threshold_text, runs[1].analysis.threshold_text);
  EXPECT_NE(runs[0].analysis.interval, runs[1].analysis.interval);
}

TEST(Fault, IsWhateverThePersonDidNotFeelInFull) {
  const Pattern pattern;
  EXPECT_FALSE(fault_of(good(1, 5), pattern));
  const auto fault = [&](auto change) {
    IntervalPlayed played = good(2, 5);
    change(played);
    return fault_of(played, pattern).value_or("none");
  };
  EXPECT_EQ(fault([](auto& p) { p.delivered_min = 0.979; }), "interval 2 was delivered at 97 %");
  EXPECT_EQ(fault([](auto& p) { p.delivered_min = 0.98; }), "none");
  EXPECT_EQ(fault([](auto& p) { p.masked_ms = 1; }), "interval 2 was masked by another effect");
  EXPECT_EQ(fault([](auto& p) { p.mixed_ms = 1; }), "interval 2 was mixed with another effect");
  EXPECT_EQ(fault([](auto& p) { p.reason = "tripped"; }), "interval 2 ended as tripped");
  EXPECT_EQ(fault([](auto& p) { p.onset_ns.reset(); }), "interval 2 never began");
  const std::string unsaid = "interval 2 ended without a word on how it was delivered";
  EXPECT_EQ(fault([](auto& p) { p.delivered_min.reset(); }), unsaid);
  EXPECT_EQ(fault([](auto& p) { p.masked_ms.reset(); }), unsaid);
  EXPECT_EQ(fault([](auto& p) { p.mixed_ms.reset(); }), unsaid);
  EXPECT_EQ(fault([](auto& p) { *p.offset_ns -= 10'000'000; }), "interval 2 was cut short");
}

TEST(Participant, IsNeverToldLevelCorrectnessOrProgress) {
  const RecordedRun run = recorded();
  for (int phase = 0; phase <= static_cast<int>(Phase::kOver); ++phase) {
    View view{&run, static_cast<Phase>(phase), 1, "level 3.45, wrong, trial 7 of 40", 41.0};
    const Cue cue = cue_of(view);
    EXPECT_EQ(decode_cue(encode(cue)), cue);
    std::string all;
    for (const std::string& line : participant_lines(cue)) {
      EXPECT_LE(line.size(), 80U);
      all += line + "\n";
    }
    EXPECT_EQ(all.find_first_of("0123456789"), std::string::npos) << all;
    for (const char* secret : {"wrong", "right", "level", "reversal", "trial", "correct"}) {
      EXPECT_THAT(all, testing::Not(HasSubstr(secret)));
    }
  }
}

TEST(Experimenter, SeesTheStaircase) {
  const RecordedRun run = recorded();
  std::string all;
  for (const std::string& line : experimenter_lines(
           {&run, Phase::kQuestion, 2, "30.0 °C, next trial at full strength", 30})) {
    all += line + "\n";
  }
  EXPECT_THAT(all, HasSubstr("P01 · force-jnd · scored trial 3 · waiting for the answer"));
  EXPECT_THAT(all, HasSubstr("level 109.024 %   reversals 1 of 10   voids 1"));
}

}  // namespace
}  // namespace hedgehog::study
