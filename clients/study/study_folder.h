// SPDX-License-Identifier: MIT
// Where a study lives: a folder with study.json (who, in which order, with which seeds) and
// journal/. It is found from below, like a repository.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/rules/experiment.h"
#include "clients/study/study_plan.h"

namespace hedgehog::study {

/// One journal file.
struct JournalName {
  std::string participant{};
  std::string experiment{};
  int run = 1;
  std::filesystem::path path{};
};

class StudyFolder {
 public:
  /// Makes folder, journal/, experiments/NAME.json as copies of `experiments`' files, and at last
  /// study.json. EX_CANTCREAT when there is one already, or another experiment of that name.
  static Result<StudyFolder> create(const std::filesystem::path& path, const StudyPlan& plan,
                                    const std::vector<std::filesystem::path>& experiments = {});
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
  /// EX_USAGE when somebody else of this study would have the same name in BIDS.
  Result<void> is_unmistakable(const std::string& participant) const;
  /// Every journal, by participant, experiment and run.
  std::vector<JournalName> journals() const;

 private:
  std::filesystem::path path_{};
  StudyPlan plan_{};
};

}  // namespace hedgehog::study
