// SPDX-License-Identifier: MIT
// All runs of a study with their analysis.
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
  /// The last finished run of its participant and experiment that is not excluded: it is included
  /// in the group. A rehearsal is not if participants took the same experiment on a real ball.
  bool in_group = false;
  /// Excluded by the experimenter, with the reason.
  std::optional<Exclusion> excluded{};
  /// The responses or the ball were simulated.
  bool is_rehearsal() const { return run.header().simulated_person || run.header().ball.simulated; }
};

/// One experiment, identical in every parameter, over its participants.
struct AnalysedGroup {
  Experiment experiment{};
  std::vector<const AnalysedRun*> runs{};  // the runs included
  GroupResult result{};                    // in the experiment's unit
  /// Mean force at, or force step of, the threshold; 0 if there is none.
  double force_n = 0.0;
  int flagged = 0;
};

/// By participant, experiment and run. Journals that cannot be read are reported in `problems`; so
/// are those without events, left by a kill, with exit code 0: no data is missing.
std::vector<AnalysedRun> collect(const StudyFolder& study, const Exclusions& exclusions,
                                 std::vector<Problem>& problems);

/// Sets `in_group`. REQUIRES: sorted by participant, experiment and run.
void choose(std::vector<AnalysedRun>& runs);

/// In the order of the plan, followed by experiments that are not in it. The result points into
/// `runs`.
std::vector<AnalysedGroup> groups_of(const StudyFolder& study,
                                     const std::vector<AnalysedRun>& runs);

/// Staircase and pattern are those of the thesis: results are comparable.
bool is_as_in_thesis(const Experiment& experiment);

/// The thesis' result for this quantity, in its unit: 2.1 A, 13 %, 49 %.
double thesis_result(Quantity quantity) noexcept;

}  // namespace hedgehog::study
