// SPDX-License-Identifier: MIT
// Excluded runs: omitted from means, marked with the reason in report and export; journals are
// unchanged.
#include "clients/study/exclusions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "clients/study/journal/journal.h"
#include "clients/study/report/bids.h"
#include "clients/study/report/html.h"
#include "clients/study/report/rows.h"
#include "clients/study/verbs/exclude_verb.h"
#include "tests/study/preset.h"
#include "tests/temporary_folder.h"

namespace hedgehog::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A study of P01 with two finished runs of force-jnd and P02 with one.
class ExcludedRuns : public testing::Test {
 protected:
  ExcludedRuns() {
    for (const auto& [participant, run] : {std::pair("P01", 1), {"P01", 2}, {"P02", 1}})
      record(participant, run, 1 + run + (participant == std::string("P02") ? 2 : 0));
  }

  /// `every`: number of right answers between two wrong ones.
  void record(const std::string& participant, int run, int every) {
    RunStarted header;
    header.participant = participant;
    header.experiment = preset("force-jnd");
    header.run = run;
    Journal journal =
        Journal::create(study_.journal_path(participant, "force-jnd", run), header).value();
    ASSERT_TRUE(journal.append(Remark{"note", "a <note> of " + participant}));
    for (int trial = 0; const auto next = journal.run().state().next(); ++trial) {
      ASSERT_TRUE(journal.append(TrialStarted{*next}));
      const bool right = trial % (every + 1) != every;
      ASSERT_TRUE(journal.append(Answered{
          (next->interval_of_test == 1) == right ? Answer::kFirst : Answer::kSecond, 500}));
    }
  }
  Exclusions exclusions() const { return Exclusions::read(study_).value(); }
  void exclude(const std::string& participant, int run, const std::string& reason) {
    Exclusions all = exclusions();
    all.add({participant, "force-jnd", run, reason, "2026-11-23T10:00:00.000Z"});
    ASSERT_TRUE(all.write());
  }
  std::vector<AnalysedRun> runs() const {
    std::vector<Problem> problems;
    return collect(study_, exclusions(), problems);
  }
  fs::path file() const { return study_.path() / "journal" / "exclusions.json"; }

  TemporaryFolder folder_;
  StudyFolder study_ =
      StudyFolder::create(folder_.path("th"), make_plan(2, {"force-jnd"}, 1)).value();
};

TEST_F(ExcludedRuns, AreInNoMeanAndReplacedByTheRunBefore) {
  auto all = runs();
  EXPECT_FALSE(all[0].in_group);
  EXPECT_TRUE(all[1].in_group && all[2].in_group);
  const double with_second = groups_of(study_, all)[0].result.mean;
  exclude("P01", 2, "fell asleep");
  all = runs();
  EXPECT_TRUE(all[0].in_group && all[2].in_group);
  EXPECT_FALSE(all[1].in_group);
  EXPECT_NE(groups_of(study_, all)[0].result.mean, with_second);
  exclude("P01", 1, "and before");
  EXPECT_EQ(groups_of(study_, runs())[0].result.count, 1);
}

TEST_F(ExcludedRuns, AreInReportAndExportWithTheReason) {
  const std::string journal = content_of(study_.journal_path("P01", "force-jnd", 2));
  exclude("P01", 2, "fell <asleep>, twice");
  const auto all = runs();
  const std::string page = report_page(study_, all, groups_of(study_, all), folder_.path("none"));
  EXPECT_THAT(page, HasSubstr("<h2>Excluded runs</h2>"));
  EXPECT_THAT(page, HasSubstr("fell &lt;asleep&gt;, twice"));
  ASSERT_TRUE(write_csv(folder_.path("data.csv"), all));
  const std::string csv = content_of(folder_.path("data.csv"));
  EXPECT_THAT(csv, HasSubstr("\"fell <asleep>, twice\""));
  const json beside = json::parse(content_of(folder_.path("data.csv.json")));
  EXPECT_EQ(beside[0]["Excluded"], "n/a");
  EXPECT_EQ(beside[1]["Excluded"], "fell <asleep>, twice");
  const auto place = [](const char* name) {
    const auto found = std::find_if(columns().begin(), columns().end(),
                                    [&](const Column& c) { return std::string(c.name) == name; });
    return static_cast<std::size_t>(found - columns().begin());
  };
  for (const auto& row : rows_of(all[1].run, {all[1].excluded->reason, false})) {
    EXPECT_EQ(row[place("included")], "0");
    EXPECT_EQ(row[place("excluded")], "fell <asleep>, twice");
  }
  EXPECT_EQ(content_of(study_.journal_path("P01", "force-jnd", 2)), journal);
}

TEST_F(ExcludedRuns, AndThoseBeforeAnotherRunAreMarkedAsInNoMean) {
  exclude("P02", 1, "fell asleep");
  ASSERT_TRUE(write_csv(folder_.path("data.csv"), runs()));
  std::istringstream lines(content_of(folder_.path("data.csv")));
  std::map<std::string, std::set<std::string>> marks;  // of each run, by the beginning of its lines
  std::string heading;
  std::getline(lines, heading);
  EXPECT_TRUE(heading.ends_with(",in_mean"));
  for (std::string line; std::getline(lines, line);)
    marks[line.substr(0, std::strlen("P01,1,force-jnd,1,"))].insert(line.substr(line.rfind(',')));
  const std::map<std::string, std::set<std::string>> expected{{"P01,1,force-jnd,1,", {",0"}},
                                                              {"P01,1,force-jnd,2,", {",1"}},
                                                              {"P02,1,force-jnd,1,", {",0"}}};
  EXPECT_EQ(marks, expected);
  const json beside = json::parse(content_of(folder_.path("data.csv.json")));
  EXPECT_EQ(beside[0]["InMean"], false);
  EXPECT_EQ(beside[1]["InMean"], true);
}

TEST_F(ExcludedRuns, AreInABidsFolderOfAnyNameAndAuthor) {
  ASSERT_TRUE(write_bids(folder_.path("bids") + "/", study_, runs(), {"J\xfcrg"}));
  const json description = json::parse(content_of(folder_.path("bids/dataset_description.json")));
  EXPECT_EQ(description["Authors"][0], "J\xef\xbf\xbdrg") << "a replacement character";
  EXPECT_FALSE(write_bids(folder_.path("bids") + "/", study_, runs()));
}

TEST_F(ExcludedRuns, CanBeIncludedAgain) {
  exclude("P01", 2, "fell asleep");
  exclude("P01", 2, "was woken");
  Exclusions all = exclusions();
  const JournalName name{"P01", "force-jnd", 2, {}};
  ASSERT_NE(all.of(name), nullptr);
  EXPECT_EQ(all.of(name)->reason, "was woken");
  EXPECT_TRUE(all.remove(name));
  EXPECT_FALSE(all.remove(name));
  ASSERT_TRUE(all.write());
  EXPECT_EQ(exclusions().of(name), nullptr);
  EXPECT_FALSE(runs()[1].excluded);
}

TEST_F(ExcludedRuns, AreRefusedIfTheFileCannotBeRead) {
  for (const char* damaged :
       {"{", "{}", R"({"excluded": [{"participant": "P01"}]})", R"({"excluded": 3, "more": [)"}) {
    std::ofstream(file()) << damaged;
    EXPECT_EQ(Exclusions::read(study_).error().exit_code, EX_DATAERR) << damaged;
  }
  std::ofstream(file()) << R"({"excluded": []})" << '\0' << "garbage";
  EXPECT_THAT(Exclusions::read(study_).error().message, HasSubstr("has a NUL byte"));
  std::ofstream(file()) << std::string(1'100'000, ' ');
  EXPECT_THAT(Exclusions::read(study_).error().message, HasSubstr("larger than"));
  fs::remove(file());
  ASSERT_EQ(::mkfifo(file().c_str(), 0600), 0);
  EXPECT_THAT(Exclusions::read(study_).error().message, HasSubstr("not a regular file"));
}

TEST_F(ExcludedRuns, AreNamedByTheVerbs) {
  const fs::path before = fs::current_path();
  fs::current_path(study_.path());
  EXPECT_EQ(run_exclude({"P01", "force-jnd", 0, "fell asleep"}), 0);
  EXPECT_EQ(run_exclude({"P03", "force-jnd", 0, "nobody"}), EX_NOINPUT);
  EXPECT_EQ(run_exclude({"P01", "force-jnd", 3, "none yet"}), EX_NOINPUT);
  EXPECT_TRUE(runs()[1].excluded);  // run 0: the last one
  EXPECT_EQ(run_include({"P01", "force-jnd", 1, ""}), EX_NOINPUT);
  EXPECT_EQ(run_include({"P01", "force-jnd", 2, ""}), 0);
  EXPECT_FALSE(runs()[1].excluded);
  fs::current_path(before);
}

TEST_F(ExcludedRuns, ABoundOfTheFitIsMarkedInTheReport) {
  auto all = runs();
  for (AnalysedRun& run : all)
    run.analysis.fit->slope_at_bound = run.analysis.fit->threshold_at_bound = false;
  const auto page = [&] {
    return report_page(study_, all, groups_of(study_, all), folder_.path("none"));
  };
  EXPECT_THAT(page(), testing::Not(HasSubstr(" *<td")));
  all[1].analysis.fit->slope_at_bound = true;
  EXPECT_THAT(page(), HasSubstr(" *<td"));
}

TEST_F(ExcludedRuns, NotesAreInTheReport) {
  const auto all = runs();
  const std::string page = report_page(study_, all, groups_of(study_, all), folder_.path("none"));
  EXPECT_THAT(page, HasSubstr("<h2>Notes</h2>"));
  EXPECT_THAT(page, HasSubstr("a &lt;note&gt; of P02"));
  EXPECT_THAT(page, testing::Not(HasSubstr("Excluded runs")));
  EXPECT_THAT(page, HasSubstr("name=\"viewport\""));
}

}  // namespace
}  // namespace hedgehog::study
