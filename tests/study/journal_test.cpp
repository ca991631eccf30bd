// SPDX-License-Identifier: MIT
// Nothing is lost: a journal truncated at any byte continues to the same levels, and nothing is
// overwritten.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>

#include "clients/study/experiment_file.h"
#include "clients/study/journal/codec.h"
#include "clients/study/journal/journal.h"
#include "clients/study/rules/observer.h"
#include "tests/rig/sanitized.h"
#include "tests/temporary_folder.h"

namespace hedgehog::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Files : public testing::Test {
 protected:
  /// In memory where possible, because each event waits for the disk.
  static fs::path place() {
    const fs::path memory = "/dev/shm";
    return ::access(memory.c_str(), W_OK) == 0 ? memory : fs::temp_directory_path();
  }
  TemporaryFolder temporary_{place()};
  const fs::path folder_ = temporary_.path();
};

RunStarted header(const std::string& experiment) {
  return {"P01",    find_experiment(experiment).value(),          1,
          {11, 22}, {"ball-7", "hedgehog-86", "7", true, 0.0127}, true,
          "0.1.0"};
}

IntervalPlayed played(int interval) {
  return {
      interval, {5, 10}, 100, 200, 300,  5'000'000'300, "completed",
      1.0,      1.0,     0,   0,   4.99, 30.5,          model::Quaternion{0.5, -0.5, 0.25, 0.125}};
}

/// The answer of a simulated observer; always the same for the same trial.
Answer answer_to(const Trial& trial, const Experiment& e) {
  const Observer o{Curve::kWeibull, e.task == Task::kYesNo ? 2.1 : 20, 3, 0.5, 0.02, 0.6};
  const bool positive = simulated_answer(o, to_value(trial.level, e.decimals()), 7,
                                         static_cast<std::uint64_t>(trial.kind), trial.number);
  if (e.task == Task::kYesNo) return positive ? Answer::kYes : Answer::kNo;
  return (trial.interval_of_test == 1) == positive ? Answer::kFirst : Answer::kSecond;
}

using Put = std::function<bool(const Event&)>;

/// Continues the run to its end or until `put` returns false. An open trial becomes void, as in the
/// program.
void continue_run(const RecordedRun& run, const Put& put) {
  if (run.open() && !put(Voided{"interrupted"})) return;
  while (!run.over()) {
    const Trial trial = *run.state().next();
    if (!put(TrialStarted{trial}) || !put(played(1)) ||
        !put(Answered{answer_to(trial, run.header().experiment), 640}))
      return;
  }
}

/// To the end, or for at most `events` events.
void continue_run(Journal& journal, int events = 1'000'000) {
  continue_run(
      journal.run(),
      [&](const Event& event) {
        if (events-- <= 0) return false;
        const bool written = journal.append(event).has_value();
        EXPECT_TRUE(written);
        return written;
      });
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

TEST_F(Files, ARunCutAfterAnyEventContinuesToTheSameLevels) {
  for (const char* experiment : {"force-threshold", "force-jnd", "speed-jnd"}) {
    const fs::path path = folder_ / experiment;
    {
      auto journal = Journal::create(path, header(experiment)).value();
      continue_run(journal);
      ASSERT_TRUE(journal.run().over());
    }
    const std::vector<Line> lines = read_journal(path).value();
    const auto expected = read_run(path).value().state().staircase().state();
    ASSERT_GT(lines.size(), 50U);
    for (std::size_t cut = 1; cut <= lines.size(); ++cut) {
      auto run =
          RecordedRun::replay({lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(cut)})
              .value();
      continue_run(run, [&](const Event& event) {
        return run.take({run.lines() + 1, "", event}).has_value();
      });
      ASSERT_EQ(run.state().staircase().state(), expected) << experiment << " " << cut;
    }
  }
}

TEST_F(Files, AJournalTruncatedAtAnyByteOfATrialContinuesToTheSameLevelsAndKeepsEveryByte) {
  const fs::path complete = folder_ / "whole";
  {
    auto journal = Journal::create(complete, header("speed-jnd")).value();
    continue_run(journal);
  }
  const std::string text = text_of(complete);
  const auto expected = read_run(complete).value().state().staircase().state();
  const std::size_t first = text.find('\n') + 1;
  const std::size_t last_trial = text.rfind('\n', text.rfind("\"trial_started\"")) + 1;
  ASSERT_GT(last_trial, first);
  // Only some bytes before the last trial, because after them many trials are repeated.
  std::vector<std::size_t> cuts;
  for (std::size_t cut = first; cut < last_trial; cut += 1213) cuts.push_back(cut);
  const std::size_t bytes = text.size() - last_trial;
  const std::size_t apart = bytes / repetitions(bytes);
  for (std::size_t cut = last_trial; cut < text.size(); cut += apart) cuts.push_back(cut);
  for (const std::size_t cut : cuts) {
    const fs::path path = folder_ / std::to_string(cut);
    std::ofstream(path, std::ios::binary) << text.substr(0, cut);
    {
      auto journal = Journal::open(path).value();
      continue_run(journal);
      ASSERT_EQ(journal.run().state().staircase().state(), expected) << cut;
    }
    EXPECT_EQ(read_run(path).value().state().staircase().state(), expected) << cut;
    EXPECT_EQ(text_of(path).substr(0, cut), text.substr(0, cut));
  }
}

TEST_F(Files, ALineWithoutItsEndIsDiscardedForGood) {
  const fs::path path = folder_ / "j";
  {
    auto journal = Journal::create(path, header("force-jnd")).value();
    continue_run(journal, 3);
  }
  fs::resize_file(path, fs::file_size(path) - 1);
  {
    auto journal = Journal::open(path).value();
    EXPECT_TRUE(journal.run().open());
    continue_run(journal, 4);
  }
  EXPECT_EQ(read_run(path).value().trials().front().void_reason, "interrupted");
}

TEST_F(Files, AMissingLineIsDetected) {
  const fs::path path = folder_ / "j";
  {
    auto journal = Journal::create(path, header("force-jnd")).value();
    continue_run(journal, 9);
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

TEST_F(Files, NoPrefixOfALineIsReadAsTheLine) {
  const fs::path path = folder_ / "j";
  {
    auto journal = Journal::create(path, header("force-threshold")).value();
    continue_run(journal, 9);
  }
  const std::string text = text_of(path);
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1) {
    const std::size_t complete = text.find('\n', begin) - begin;
    EXPECT_TRUE(decode(text.substr(begin, complete)).has_value());
    for (std::size_t length = 0; length < complete; ++length)
      ASSERT_FALSE(decode(text.substr(begin, length)).has_value()) << text.substr(begin, length);
  }
}

TEST_F(Files, ADamagedLineIsNoTruncatedOneAtAnyPosition) {
  const fs::path path = folder_ / "j";
  {
    auto journal = Journal::create(path, header("force-jnd")).value();
    continue_run(journal, 9);
  }
  const std::string text = text_of(path);
  std::vector<std::size_t> ends;
  for (auto at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
    ends.push_back(at);
  for (std::size_t line = 0; line < ends.size(); ++line) {
    std::string damaged = text;
    damaged.erase(ends[line] - 3, 3);
    std::ofstream(path, std::ios::binary) << damaged;
    for (const auto& problem : {read_run(path).error(), Journal::open(path).error()}) {
      EXPECT_EQ(problem.exit_code, EX_DATAERR);
      EXPECT_THAT(problem.message, HasSubstr("line " + std::to_string(line + 1) + " is damaged"));
    }
    EXPECT_TRUE(has_begun(path));
    EXPECT_EQ(text_of(path), damaged);
  }
}

TEST_F(Files, ANulEndsNoLine) {
  const std::string line = encode({1, utc_now(), header("force-jnd")});
  EXPECT_TRUE(decode(line).has_value());
  EXPECT_THAT(decode(line + '\0' + "garbage").error().message, HasSubstr("has a NUL byte"));
}

TEST_F(Files, AFullDiskIsAnErrorAndLosesNoLaterEvent) {
  const fs::path path = folder_ / "j";
  std::optional<Trial> due;
  {
    auto journal = Journal::create(path, header("force-jnd")).value();
    continue_run(journal, 9);
    due = journal.run().state().next();
    // The next line fits only in part.
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit full{fs::file_size(path) + 20, before.rlim_max};
    const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &full);
    const auto written = journal.append(TrialStarted{*due});
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, ignored);
    ASSERT_FALSE(written.has_value());
    EXPECT_EQ(written.error().exit_code, EX_IOERR);
    EXPECT_EQ(journal.run().lines(), 10);
    EXPECT_FALSE(journal.run().open());
  }
  auto again = Journal::open(path).value();
  EXPECT_EQ(again.run().lines(), 10);
  EXPECT_EQ(again.run().state().next(), due);
  continue_run(again);
  EXPECT_TRUE(read_run(path).value().over());
}

TEST_F(Files, NothingIsOverwrittenAndThereIsOneWriter) {
  const fs::path path = folder_ / "j";
  auto journal = Journal::create(path, header("force-jnd")).value();
  EXPECT_EQ(Journal::create(path, header("force-jnd")).error().exit_code, EX_CANTCREAT);
  EXPECT_EQ(Journal::open(path).error().exit_code, EX_TEMPFAIL);
}

TEST_F(Files, AnEventOutOfOrderIsRefused) {
  auto journal = Journal::create(folder_ / "j", header("force-jnd")).value();
  EXPECT_FALSE(journal.append(Answered{Answer::kFirst, 1}).has_value());
  EXPECT_FALSE(journal.append(TrialStarted{{TrialKind::kScored, 9, 1, 5, 1}}).has_value());
  ASSERT_TRUE(journal.append(TrialStarted{*journal.run().state().next()}).has_value());
  EXPECT_FALSE(journal.append(Answered{Answer::kYes, 1}).has_value());
  EXPECT_EQ(journal.run().lines(), 2);
}

}  // namespace
}  // namespace hedgehog::study
