// SPDX-License-Identifier: MIT
#include "clients/study/report/collect.h"

#include <algorithm>

#include "clients/study/journal/journal.h"
#include "clients/study/rules/statistics.h"

namespace hedgehog::study {

double thesis_result(Quantity quantity) noexcept {
  switch (quantity) {
    case Quantity::kCurrentPercent:
      return 13.0;
    case Quantity::kSpeedPercent:
      return 49.0;
    case Quantity::kCurrentA:
      break;
  }
  return 2.1;
}

std::vector<AnalysedRun> collect(const StudyFolder& study, int bootstraps,
                                 std::vector<std::string>& problems) {
  std::vector<AnalysedRun> all;
  for (const JournalName& name : study.journals()) {
    auto run = read_run(name.path);
    if (!run) {
      problems.push_back(run.error().message);
      continue;
    }
    AnalysisOptions options;
    options.bootstraps = bootstraps;
    options.seed = study.plan().seed;
    options.force_n_per_a = run->header().ball.force_n_per_a;
    const RunAnalysis analysis = analyse(run->header().experiment, run->state(), options);
    all.push_back({name, *std::move(run), analysis, false});
  }
  // Sorted by run: the last finished one of each takes the place of those before.
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].analysis.threshold) {
      continue;
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (all[j].name.participant == all[i].name.participant &&
          all[j].name.experiment == all[i].name.experiment) {
        all[j].in_group = false;
      }
    }
    all[i].in_group = true;
  }
  return all;
}

std::vector<AnalysedGroup> groups_of(const StudyFolder& study,
                                     const std::vector<AnalysedRun>& runs) {
  std::vector<std::string> names = study.plan().experiments;
  for (const AnalysedRun& run : runs) {
    if (std::find(names.begin(), names.end(), run.name.experiment) == names.end()) {
      names.push_back(run.name.experiment);
    }
  }
  std::vector<AnalysedGroup> groups;
  for (const std::string& name : names) {
    AnalysedGroup group;
    std::vector<double> thresholds;
    std::vector<double> forces;
    for (const AnalysedRun& run : runs) {
      if (run.in_group && run.name.experiment == name) {
        group.experiment = run.run.header().experiment;
        group.runs.push_back(&run);
        thresholds.push_back(*run.analysis.threshold);
        forces.push_back(run.analysis.force_n.value_or(0.0));
        group.flagged += run.analysis.flags.empty() ? 0 : 1;
      }
    }
    if (!group.runs.empty()) {
      group.result = study::group(thresholds);
      group.force_n = mean(forces);
      groups.push_back(group);
    }
  }
  return groups;
}

}  // namespace hedgehog::study
