// SPDX-License-Identifier: MIT
// Where a study lives: a folder with study.json (who, in which order, with which seeds) and
// journal/. It is found from below, like a repository.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "clients/study/problem.h"
#include "clients/study/rules/run.h"

namespace hedgehog::study {

struct Participant {
  std::string id{};
  std::vector<std::string> order{};  // names of experiments
  std::uint64_t seed = 0;            // below 2^53, so that any JSON reader keeps it
};

struct StudyPlan {
  std::uint64_t seed = 0;
  std::vector<std::string> experiments{};
  std::vector<Participant> participants{};
  std::string created{};
  std::string software_version{};

  const Participant* participant(const std::string& id) const noexcept;
};

/// The orders of `count` conditions in which each stands in each place, and behind each other one,
/// equally often (Williams 1949): count rows for an even count, twice as many for an odd one.
std::vector<std::vector<int>> latin_square(int count);

/// P01, P02, ...; the order by the participant's place in the square, the seeds from `seed`.
StudyPlan make_plan(int participants, std::vector<std::string> experiments, std::uint64_t seed);

/// The streams of one run, from the participant's seed.
RunSeeds run_seeds(const Participant& participant, const std::string& experiment, int run);

/// One journal file.
struct JournalName {
  std::string participant{};
  std::string experiment{};
  int run = 1;
  std::filesystem::path path{};
};

class StudyFolder {
 public:
  /// Makes folder, study.json and journal/. EX_CANTCREAT when there is a study.json already.
  static Result<StudyFolder> create(const std::filesystem::path& path, const StudyPlan& plan);
  /// In `from` or the nearest folder above it. EX_NOINPUT when there is none.
  static Result<StudyFolder> find(const std::filesystem::path& from);

  const std::filesystem::path& path() const noexcept { return path_; }
  const StudyPlan& plan() const noexcept { return plan_; }
  std::filesystem::path journal_path(const std::string& participant, const std::string& experiment,
                                     int run) const;
  /// The study's own experiments/NAME.json if there is one, else as `find_experiment`.
  Result<Experiment> experiment(const std::string& name_or_file) const;
  /// EX_CONFIG when a preset, or an experiment that this study has a journal of, has the same name
  /// and is another one: their results would be taken for each other's.
  Result<void> is_unmistakable(const Experiment& experiment) const;
  /// Copies an experiment's file to experiments/NAME.json. EX_CANTCREAT when that is there already.
  Result<void> adopt(const Experiment& experiment, const std::filesystem::path& file) const;
  /// Every journal, by participant, experiment and run.
  std::vector<JournalName> journals() const;

 private:
  std::filesystem::path path_{};
  StudyPlan plan_{};
};

}  // namespace hedgehog::study
