// SPDX-License-Identifier: MIT
// Every run of a study with what it says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/study/exclusions.h"
#include "clients/study/journal/recorded_run.h"
#include "clients/study/rules/analysis.h"
#include "clients/study/study_folder.h"

namespace hedgehog::study {

struct AnalysedRun {
  JournalName name{};
  RecordedRun run;
  RunAnalysis analysis{};
  /// The last finished run of its participant and experiment that is not excluded: it counts for
  /// the group. A rehearsal does not where people took the same experiment on a real ball.
  bool in_group = false;
  /// Left out by the experimenter, for a reason.
  std::optional<Exclusion> excluded{};
  /// A program answered, or nobody felt anything: the ball was simulated.
  bool is_rehearsal() const { return run.header().simulated_person || run.header().ball.simulated; }
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

/// By participant, experiment and run. Journals that cannot be read are told in `problems`; one
/// that a kill left before its first event too, with exit code 0: nothing is missing.
std::vector<AnalysedRun> collect(const StudyFolder& study, const Exclusions& exclusions,
                                 std::vector<Problem>& problems);

/// Sets `in_group`. By participant, experiment and run.
void choose(std::vector<AnalysedRun>& runs);

/// In the order of the plan; experiments that are not in it behind. The result points into `runs`.
std::vector<AnalysedGroup> groups_of(const StudyFolder& study,
                                     const std::vector<AnalysedRun>& runs);

/// Its staircase and its pattern are the thesis': a comparison says something.
bool is_as_in_thesis(const Experiment& experiment);

/// What the thesis found about this quantity, in its unit: 2.1 A, 13 %, 49 %.
double thesis_result(Quantity quantity) noexcept;

}  // namespace hedgehog::study
