// SPDX-License-Identifier: MIT
// Nothing is lost: a journal cut at any byte goes on to the same levels, and nothing is
// overwritten.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "clients/study/experiment_file.h"
#include "clients/study/journal/codec.h"
#include "clients/study/journal/journal.h"
#include "clients/study/rules/observer.h"
#include "clients/study/study_folder.h"

namespace hedgehog::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Files : public testing::Test {
 protected:
  Files() {
    std::string pattern = (fs::temp_directory_path() / "hedgehog-study-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~Files() override { fs::remove_all(folder_); }
  fs::path folder_;
};

RunStarted header(const std::string& experiment) {
  return {"P01",    find_experiment(experiment).value(),          1,
          {11, 22}, {"ball-7", "hedgehog-86", "7", true, 0.0127}, true,
          "0.1.0"};
}

IntervalPlayed played(int interval) {
  return {interval, {5, 10}, 100, 200, 300, 5'000'000'300, "completed", 1.0, 1.0, 0, 0, 4.99, 30.5};
}

/// What somebody simulated answers: the same for a trial however often it is asked.
Answer answer_to(const Trial& trial, const Experiment& e) {
  const Observer o{Curve::kWeibull, e.task == Task::kYesNo ? 2.1 : 20, 3, 0.5, 0.02, 0.6};
  const bool positive = simulated_answer(o, to_value(trial.level, e.decimals()), 7,
                                         static_cast<std::uint64_t>(trial.kind), trial.number);
  if (e.task == Task::kYesNo) {
    return positive ? Answer::kYes : Answer::kNo;
  }
  return (trial.interval_of_test == 1) == positive ? Answer::kFirst : Answer::kSecond;
}

/// Takes the run to its end, or for so many events; as the program does: an open trial is void.
void go_on(Journal& journal, int events = 1'000'000) {
  const auto put = [&](const Event& event) {
    if (events-- > 0) {
      ASSERT_TRUE(journal.append(event).has_value());
    }
  };
  if (journal.run().open()) {
    put(Voided{"interrupted"});
  }
  while (events > 0 && !journal.run().over()) {
    const Trial trial = *journal.run().state().next();
    put(TrialStarted{trial});
    put(played(1));
    put(Answered{answer_to(trial, journal.run().header().experiment), 640});
  }
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(Files, AJournalReadsBackEveryEvent) {
  const std::vector<Event> events{header("force-jnd"),
                                  Checklist{true, true, "sheet 014", 18.4, "right", "22-29", "E1"},
                                  Checklist{true, false, "", std::nullopt, "left", "", ""},
                                  TrialStarted{{TrialKind::kCatch, 3, 2, 0, 0}},
                                  played(2),
                                  IntervalPlayed{1,
                                                 {3.4512, 10},
                                                 1,
                                                 2,
                                                 std::nullopt,
                                                 std::nullopt,
                                                 "stopped",
                                                 0.5,
                                                 0.9,
                                                 3,
                                                 4,
                                                 std::nullopt,
                                                 std::nullopt},
                                  Answered{Answer::kSecond, 1234},
                                  Voided{"no answer in time"},
                                  Remark{"note", "coughed; \"quoted\"\nand broken"}};
  for (const Event& event : events) {
    const Line line{5, "2026-11-21T15:04:05.123Z", event};
    const std::string text = encode(line);
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_EQ(decode(text).value(), line) << text;
  }
  EXPECT_FALSE(decode("{\"n\":1}").has_value());
}

TEST_F(Files, ARunCutAfterAnyEventGoesOnToTheSameLevels) {
  for (const char* experiment : {"force-threshold", "force-jnd"}) {
    auto whole =
        Journal::create(folder_ / (std::string(experiment) + ".whole"), header(experiment)).value();
    go_on(whole);
    ASSERT_TRUE(whole.run().over());
    const auto expected = whole.run().state().staircase().state();
    const int lines = static_cast<int>(whole.run().lines());
    for (int cut = 0; cut < lines; cut += 29) {
      const fs::path path = folder_ / (experiment + std::to_string(cut));
      {
        auto journal = Journal::create(path, header(experiment)).value();
        go_on(journal, cut);
      }
      auto journal = Journal::open(path).value();
      go_on(journal);
      EXPECT_EQ(journal.run().state().staircase().state(), expected) << cut;
    }
  }
}

TEST_F(Files, AJournalTornAtAnyByteGoesOnToTheSameLevelsAndKeepsEveryByte) {
  const fs::path whole = folder_ / "whole";
  {
    auto journal = Journal::create(whole, header("speed-jnd")).value();
    go_on(journal);
  }
  const std::string text = text_of(whole);
  const auto expected = read_run(whole).value().state().staircase().state();
  const std::size_t first = text.find('\n') + 1;
  for (std::size_t cut = first; cut < text.size(); cut += 1213) {
    const fs::path path = folder_ / std::to_string(cut);
    std::ofstream(path, std::ios::binary) << text.substr(0, cut);
    {
      auto journal = Journal::open(path).value();
      go_on(journal);
      ASSERT_EQ(journal.run().state().staircase().state(), expected) << cut;
    }
    EXPECT_EQ(read_run(path).value().state().staircase().state(), expected) << cut;
    EXPECT_EQ(text_of(path).substr(0, cut), text.substr(0, cut));
  }
}

TEST_F(Files, ALineThatOnlyLostItsEndIsNotFollowedAndNeverComesBack) {
  const fs::path path = folder_ / "j";
  {
    auto journal = Journal::create(path, header("force-jnd")).value();
    go_on(journal, 3);
  }
  fs::resize_file(path, fs::file_size(path) - 1);
  {
    auto journal = Journal::open(path).value();
    EXPECT_TRUE(journal.run().open());
    go_on(journal, 4);
  }
  EXPECT_EQ(read_run(path).value().trials().front().void_reason, "interrupted");
}

TEST_F(Files, AMissingLineIsNoticed) {
  const fs::path path = folder_ / "j";
  {
    auto journal = Journal::create(path, header("force-jnd")).value();
    go_on(journal, 9);
  }
  std::string text = text_of(path);
  const auto second = text.find('\n') + 1;
  text.erase(second, text.find('\n', second) + 1 - second);
  std::ofstream(path, std::ios::binary) << text;
  const auto read = read_run(path);
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().exit_code, EX_DATAERR);
  EXPECT_THAT(read.error().message, HasSubstr("lines are missing"));
}

TEST_F(Files, NothingIsOverwrittenAndOneWritesAtATime) {
  const fs::path path = folder_ / "j";
  auto journal = Journal::create(path, header("force-jnd")).value();
  EXPECT_EQ(Journal::create(path, header("force-jnd")).error().exit_code, EX_CANTCREAT);
  EXPECT_EQ(Journal::open(path).error().exit_code, EX_TEMPFAIL);
}

TEST_F(Files, WhatDoesNotFollowIsRefused) {
  auto journal = Journal::create(folder_ / "j", header("force-jnd")).value();
  EXPECT_FALSE(journal.append(Answered{Answer::kFirst, 1}).has_value());
  EXPECT_FALSE(journal.append(TrialStarted{{TrialKind::kScored, 9, 1, 5, 1}}).has_value());
  ASSERT_TRUE(journal.append(TrialStarted{*journal.run().state().next()}).has_value());
  EXPECT_FALSE(journal.append(Answered{Answer::kYes, 1}).has_value());
  EXPECT_EQ(journal.run().lines(), 2);
}

TEST_F(Files, AStudyIsFoundFromBelowAndNeverMadeTwice) {
  const StudyPlan plan = make_plan(10, {"force-threshold", "force-jnd", "speed-jnd"}, 2026);
  ASSERT_TRUE(StudyFolder::create(folder_ / "thresholds", plan).has_value());
  EXPECT_EQ(StudyFolder::create(folder_ / "thresholds", plan).error().exit_code, EX_CANTCREAT);
  const auto found = StudyFolder::find(folder_ / "thresholds" / "journal").value();
  ASSERT_EQ(found.plan().participants.size(), 10U);
  EXPECT_EQ(found.plan().participant("P07")->seed, plan.participants[6].seed);
  EXPECT_EQ(found.plan().participant("P07")->order, plan.participants[6].order);
  EXPECT_EQ(found.plan().participant("P11"), nullptr);
  EXPECT_EQ(StudyFolder::find(folder_).error().exit_code, EX_NOINPUT);
}

TEST(Plan, TheSameSeedMakesTheSamePlan) {
  const StudyPlan a = make_plan(3, {"a", "b"}, 5);
  const StudyPlan b = make_plan(3, {"a", "b"}, 5);
  EXPECT_EQ(a.participants[2].seed, b.participants[2].seed);
  EXPECT_NE(a.participants[1].seed, a.participants[2].seed);
  EXPECT_NE(run_seeds(a.participants[0], "a", 1), run_seeds(a.participants[0], "a", 2));
  EXPECT_NE(run_seeds(a.participants[0], "a", 1), run_seeds(a.participants[0], "b", 1));
}

TEST(Plan, EachExperimentStandsInEachPlaceAndBehindEachOtherEquallyOften) {
  for (int count = 1; count <= 6; ++count) {
    std::map<std::pair<int, int>, int> places;
    std::map<std::pair<int, int>, int> followers;
    const auto rows = latin_square(count);
    EXPECT_EQ(static_cast<int>(rows.size()), count % 2 == 0 || count == 1 ? count : 2 * count);
    for (const auto& row : rows) {
      for (int place = 0; place < count; ++place) {
        ++places[{place, row[static_cast<std::size_t>(place)]}];
        if (place > 0) {
          ++followers[{row[static_cast<std::size_t>(place - 1)],
                       row[static_cast<std::size_t>(place)]}];
        }
      }
    }
    EXPECT_EQ(static_cast<int>(places.size()), count * count);
    for (const auto& [which, times] : places) {
      EXPECT_EQ(times, static_cast<int>(rows.size()) / count);
    }
    EXPECT_EQ(static_cast<int>(followers.size()), count * (count - 1));
    for (const auto& [which, times] : followers) {
      EXPECT_EQ(times, followers.begin()->second);
    }
  }
}

}  // namespace
}  // namespace hedgehog::study
