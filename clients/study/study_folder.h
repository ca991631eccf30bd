// SPDX-License-Identifier: MIT
// The files of a study: a folder with study.json (participants, orders, seeds) and journal/. It is
// found from subfolders, like a repository.
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
  /// Creates folder, journal/, experiments/NAME.json as copies of `experiments`' files, and finally
  /// study.json. EX_CANTCREAT if that exists, or another experiment of that name.
  static Result<StudyFolder> create(const std::filesystem::path& path, const StudyPlan& plan,
                                    const std::vector<std::filesystem::path>& experiments = {});
  /// In `from` or the nearest folder above it. EX_NOINPUT if there is none.
  static Result<StudyFolder> find(const std::filesystem::path& from);

  const std::filesystem::path& path() const noexcept { return path_; }
  const StudyPlan& plan() const noexcept { return plan_; }
  std::filesystem::path journal_path(const std::string& participant, const std::string& experiment,
                                     int run) const;
  /// The study's own experiments/NAME.json if it exists, otherwise by `find_experiment`.
  Result<Experiment> experiment(const std::string& name_or_file) const;
  /// EX_CONFIG if a preset, or an experiment with a journal in this study, has the same name and
  /// differs: their results would be mixed up.
  Result<void> is_unmistakable(const Experiment& experiment) const;
  /// EX_USAGE if another participant of this study has the same BIDS label.
  Result<void> is_unmistakable(const std::string& participant) const;
  /// All journals, by participant, experiment and run.
  std::vector<JournalName> journals() const;

 private:
  std::filesystem::path path_{};
  StudyPlan plan_{};
};

}  // namespace hedgehog::study
