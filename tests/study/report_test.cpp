// SPDX-License-Identifier: MIT
// The output of a study: rows, groups, figures and exported files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "clients/common/csv.h"
#include "clients/study/experiment_file.h"
#include "clients/study/journal/journal.h"
#include "clients/study/report/bids.h"
#include "clients/study/report/collect.h"
#include "clients/study/report/figures.h"
#include "clients/study/report/rows.h"
#include "clients/study/report/sidecar.h"
#include "tests/study/recorded.h"
#include "tests/temporary_folder.h"

namespace hedgehog::study {
namespace {

using testing::HasSubstr;

std::map<std::string, std::string> named(const std::vector<std::string>& row) {
  std::map<std::string, std::string> cells;
  for (std::size_t i = 0; i < row.size(); ++i) cells[columns()[i].name] = row[i];
  return cells;
}

TEST(Rows, AreOneForEachPresentationBlock) {
  const auto rows = rows_of(recorded(), {});
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), columns().size());
    auto cells = named(row);
    for (const char* column : {"time", "onset", "orientation_w"})
      EXPECT_NE(cells[column], "n/a") << cells["kind"] << ": " << column;
  }
  EXPECT_EQ(columns().size(), 43U);
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
  EXPECT_EQ(right["t_offset_1"], "12");
  EXPECT_EQ(right["t_onset_2"], "13");
  EXPECT_EQ(right["onset_2"], "6");  // since the run's first onset, at 7 s too
  EXPECT_EQ(right["time"], "t");
  EXPECT_EQ(right["excluded"], "n/a");
  EXPECT_EQ(right["orientation_w"], "0.5");
  EXPECT_EQ(right["orientation_z"], "-0.5");
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

/// A trial with the answer "first": UTC of its start and of its interval's end, device time of its
/// command.
struct StartedTrial {
  const char* utc;
  const char* played_utc;
  std::int64_t command_ms;
  /// Daemon or program were interrupted before this trial.
  bool resumed = false;
};

std::vector<std::string> onsets(const std::vector<StartedTrial>& trials) {
  RunStarted header;
  header.experiment = find_experiment("force-jnd").value();
  header.experiment.practice = 0;
  std::vector<Line> lines{{1, "2026-11-21T09:59:00.000Z", header}};
  const auto put = [&](const std::string& utc, const Event& event) {
    lines.push_back({static_cast<std::int64_t>(lines.size()) + 1, utc, event});
  };
  for (const StartedTrial& trial : trials) {
    if (trial.resumed) put(trial.utc, Remark{"resumed", "ball"});
    put(trial.utc, TrialStarted{*RecordedRun::replay(lines).value().state().next()});
    IntervalPlayed played = good(1, 5);
    played.command_ns = trial.command_ms * 1'000'000;
    played.onset_ns = played.command_ns + 500'000'000;
    played.offset_ns = *played.onset_ns + 5'000'000'000;
    put(trial.played_utc, played);
    put(trial.played_utc, Answered{Answer::kFirst, 640});
  }
  std::vector<std::string> found;
  for (const auto& row : rows_of(RecordedRun::replay(lines).value(), {}))
    found.push_back(named(row)["onset"]);
  return found;
}

TEST(Rows, ContinueByTheWallClockWhereTheDevicesClockRestarted) {
  const StartedTrial first{"2026-11-21T10:00:00.000Z", "2026-11-21T10:00:05.500Z", 100'000};
  // Ten minutes after the end of the first one; the device time is lower, or by chance higher.
  const StartedTrial interrupted{"2026-11-21T10:10:05.500Z", "2026-11-21T10:10:11.000Z", 3'000,
                                 true};
  StartedTrial later = interrupted;
  later.command_ms = 200'000;
  StartedTrial unmarked = interrupted;
  unmarked.resumed = false;
  for (const StartedTrial& second : {interrupted, later, unmarked}) {
    StartedTrial third = second;
    third.command_ms += 20'000;
    third.resumed = false;
    EXPECT_THAT(onsets({first, second, third}), testing::ElementsAre("0", "605.5", "625.5"));
  }
  // A wall clock that was set back meanwhile moves no onset back.
  StartedTrial back = interrupted;
  back.utc = "2026-11-21T08:00:00.000Z";
  EXPECT_THAT(onsets({first, back}), testing::ElementsAre("0", "5.5"));
  // An unreadable time gives no onset.
  back.utc = "t";
  EXPECT_THAT(onsets({first, back}), testing::ElementsAre("0", "n/a"));
}

TEST(Rows, AreQuotedWhereNeeded) {
  EXPECT_EQ(client::csv_line({"a", "b,c", "d\"e", ""}), "a,\"b,c\",\"d\"\"e\",");
  EXPECT_EQ(tsv_line({"a", "b\tc\nd"}), "a\tb c d");
}

TEST(Sidecar, HasTheParametersOfItsExperiment) {
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

TEST(Sidecar, NamesTheProgramAsBidsRequires) {
  const AnalysedRun run{{"P01", "force-jnd", 1, {}}, recorded(), {}, true};
  const auto file = nlohmann::json::parse(bids_sidecar(run));
  EXPECT_EQ(file["StimulusPresentation"]["SoftwareName"], "hedgehog-study");
  EXPECT_EQ(file["StimulusPresentation"]["SoftwareVersion"], "0.1.0");
  EXPECT_THAT(file["StimulusPresentation"]["OperatingSystem"], HasSubstr("Linux"));
  for (const Column& column : columns()) EXPECT_TRUE(file.contains(column.name)) << column.name;
}

TEST(Figure, MarksReversalsAndTheMean) {
  AnalysedRun run{{"P01", "force-jnd", 1, {}}, recorded(), {}, true};
  run.analysis.threshold = 13.25;
  const std::string plot = staircase_plot(run);
  EXPECT_THAT(plot, HasSubstr("1 100 1\n2 89.024 0\nEND"));
  EXPECT_THAT(plot, HasSubstr("$reversals << END\n2 89.024 1\nEND"));
  EXPECT_THAT(plot, HasSubstr("mean of reversals, 13.25 %"));
  EXPECT_THAT(plot, testing::Not(HasSubstr("95 %")));
  run.analysis.interval = Interval{8.0, 19.0};
  EXPECT_THAT(staircase_plot(run), HasSubstr("title '95 % of the fitted curve'"));
  EXPECT_THAT(staircase_plot(run), testing::Not(HasSubstr("disagree")));
  run.analysis.flags = {Flag::kDisagreement};
  EXPECT_THAT(staircase_plot(run), HasSubstr("mean of reversals, 13.25 % (fit and mean disagree)"));
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

TEST(Groups, HaveOneExperimentAndNoProgramsAmongPeople) {
  std::vector<AnalysedRun> runs{threshold_of("P01", 1, 10, false),
                                threshold_of("P01", 2, 12, false), threshold_of("P01", 3, 99, true),
                                threshold_of("P02", 1, 14, false),
                                threshold_of("P03", 1, 50, true, 3)};
  choose(runs);
  const TemporaryFolder folder;
  const StudyFolder study =
      StudyFolder::create(folder.path(), make_plan(3, {"force-jnd"}, 1)).value();
  const auto groups = groups_of(study, runs);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].result.count, 2);
  EXPECT_EQ(groups[0].result.mean, 13);
  // Another rule under the same name is a separate group, here without people.
  EXPECT_EQ(groups[1].result.count, 1);
  EXPECT_EQ(groups[1].result.mean, 50);
}

TEST(Groups, ListPeopleOnASimulatedBallAfterThoseOnARealOne) {
  std::vector<AnalysedRun> runs{threshold_of("P01", 1, 10, false),
                                threshold_of("P02", 1, 14, false)};
  RunStarted header = runs[1].run.header();
  header.ball.simulated = true;
  runs[1].run = RecordedRun::replay({{1, "t", header}}).value();
  choose(runs);
  EXPECT_TRUE(runs[1].is_rehearsal());
  EXPECT_TRUE(runs[0].in_group);
  EXPECT_FALSE(runs[1].in_group);
}

TEST(Figure, OfAGroupHasEachPersonsForceByTheirOwnBall) {
  std::vector<AnalysedRun> runs;
  for (const double force_n : {0.02, 0.04}) {
    RunStarted header;
    header.experiment = find_experiment("force-threshold-thesis").value();
    header.participant = "P0" + std::to_string(runs.size() + 1);
    runs.push_back({{header.participant, header.experiment.name, 1, {}},
                    RecordedRun::replay({{1, "t", header}}).value(),
                    {},
                    true});
    runs.back().analysis.threshold = 2.0;
    runs.back().analysis.force_n = force_n;
  }
  AnalysedGroup group{runs[0].run.header().experiment, {&runs[0], &runs[1]}, {2, 2.0, 0.0}};
  const std::string plot = group_plot({group});
  EXPECT_THAT(plot, HasSubstr("$mean << END\n0.45 0.03 0.0141421356\nEND"));
  EXPECT_THAT(plot, HasSubstr("plot 0.02646 with lines"));  // 2.1 A with the thesis' ball
  EXPECT_THAT(plot, HasSubstr("\"Force threshold [N]\\nforce-threshold-thesis\""));
  group.experiment.rule.discard = 3;
  EXPECT_THAT(group_plot({group}), testing::Not(HasSubstr("'thesis'")));
}

TEST(Figure, IsDrawnInAFolderOfAnyName) {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path("it's \"$here\"");
  std::filesystem::create_directories(folder);
  AnalysedRun run{{"P01", "force-jnd", 1, {}}, recorded(), {}, true};
  run.analysis.threshold = 13.25;
  run.analysis.interval = Interval{8.0, 19.0};
  const auto drawn = draw(folder, {run}, {});
  ASSERT_TRUE(drawn) << drawn.error().message;
  EXPECT_GT(std::filesystem::file_size(folder + "/P01.force-jnd.1.svg"), 2000U);
  EXPECT_GT(std::filesystem::file_size(folder + "/P01.force-jnd.1.png"), 2000U);
}

TEST(Bids, RefusesAmbiguousPeopleAndExperiments) {
  const TemporaryFolder folder;
  const std::filesystem::path base = folder.path();
  const StudyFolder study = StudyFolder::create(base, make_plan(1, {"force-jnd"}, 1)).value();
  const auto refused = [&](const AnalysedRun& a, const AnalysedRun& b) {
    const auto written = write_bids(base / "bids", study, {a, b});
    EXPECT_FALSE(std::filesystem::exists(base / "bids"));
    return written ? std::string("written") : written.error().message;
  };
  const AnalysedRun one = threshold_of("P1", 1, 10, false);
  AnalysedRun experiment = threshold_of("P1", 1, 10, false);
  experiment.name.experiment = "forcejnd";
  EXPECT_THAT(refused(one, threshold_of("P_1", 1, 10, false)),
              HasSubstr("P1 and P_1 would be sub-P1"));
  EXPECT_THAT(refused(one, threshold_of("P-1", 2, 10, false)), HasSubstr("P-1 and P1"));
  EXPECT_THAT(refused(one, experiment), HasSubstr("would be task-forcejnd"));
  ASSERT_TRUE(write_bids(base / "bids", study, {one, threshold_of("P2", 1, 10, false)}));
  std::ifstream participants(base / "bids" / "participants.json");
  EXPECT_EQ(nlohmann::json::parse(participants)["hand_size_cm"]["Units"], "cm");
  std::ifstream description(base / "bids" / "dataset_description.json");
  EXPECT_EQ(nlohmann::json::parse(description)["Authors"],
            nlohmann::json::array({"n/a", "hedgehog-study"}));
  EXPECT_EQ(write_bids(base / "bids", study, {one}).error().exit_code, EX_CANTCREAT);
  // A failed export leaves nothing behind that would obstruct the next one.
  EXPECT_FALSE(write_csv(base / "nowhere" / "data.csv", {one}));
  EXPECT_FALSE(write_bids(base / "study.json" / "bids", study, {one}));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(base), {}), 3);
}

}  // namespace
}  // namespace hedgehog::study
