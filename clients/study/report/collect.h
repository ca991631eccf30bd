// SPDX-License-Identifier: MIT
// Every run of a study with what it says.
#pragma once

#include <string>
#include <vector>

#include "clients/study/journal/recorded_run.h"
#include "clients/study/rules/analysis.h"
#include "clients/study/study_folder.h"

namespace hedgehog::study {

struct AnalysedRun {
  JournalName name{};
  RecordedRun run;
  RunAnalysis analysis{};
  /// The last finished run of its participant and experiment: it counts for the group. A simulated
  /// one does not where people took the same experiment.
  bool in_group = false;
};

/// One experiment, the same in every number, over its participants.
struct AnalysedGroup {
  Experiment experiment{};
  std::vector<const AnalysedRun*> runs{};  // those that count
  GroupResult result{};                    // in the experiment's unit
  /// Mean force at, or force step of, the threshold; 0 where there is none.
  double force_n = 0.0;
  int flagged = 0;
};

/// By participant, experiment and run. Journals that cannot be read are told in `problems`.
std::vector<AnalysedRun> collect(const StudyFolder& study, int bootstraps,
                                 std::vector<std::string>& problems);

/// Sets `in_group`. By participant, experiment and run.
void choose(std::vector<AnalysedRun>& runs);

/// In the order of the plan; experiments that are not in it behind. The result points into `runs`.
std::vector<AnalysedGroup> groups_of(const StudyFolder& study,
                                     const std::vector<AnalysedRun>& runs);

/// What the thesis found in this experiment, in its unit: 2.1 A, 13 %, 49 %.
double thesis_result(Quantity quantity) noexcept;

}  // namespace hedgehog::study
