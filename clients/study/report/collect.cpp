// SPDX-License-Identifier: MIT
#include "clients/study/report/collect.h"

#include <algorithm>

#include "clients/study/experiment_file.h"
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

bool is_as_in_thesis(const Experiment& experiment) {
  for (const char* preset : {"force-threshold-thesis", "force-jnd", "speed-jnd"}) {
    const auto thesis = find_experiment(preset);
    if (thesis && thesis->quantity == experiment.quantity && thesis->task == experiment.task &&
        thesis->rule == experiment.rule && thesis->pattern == experiment.pattern)
      return true;
  }
  return false;
}

std::vector<AnalysedRun> collect(const StudyFolder& study, const Exclusions& exclusions,
                                 std::vector<Problem>& problems) {
  std::vector<AnalysedRun> all;
  for (const JournalName& name : study.journals()) {
    if (!has_begun(name.path)) {
      problems.push_back({0, name.path.string() + " was killed before it began: left out"});
      continue;
    }
    auto run = read_run(name.path);
    if (!run) {
      problems.push_back(run.error());
      continue;
    }
    AnalysisOptions options;
    options.force_n_per_a = run->header().ball.force_n_per_a;
    const RunAnalysis analysis = analyse(run->header().experiment, run->state(), options);
    all.push_back({name, *std::move(run), analysis, false, {}});
    if (const Exclusion* exclusion = exclusions.of(name)) all.back().excluded = *exclusion;
  }
  choose(all);
  return all;
}

void choose(std::vector<AnalysedRun>& all) {
  const auto same = [](const AnalysedRun& a, const AnalysedRun& b) {
    return a.run.header().experiment == b.run.header().experiment;
  };
  for (AnalysedRun& run : all) {
    // Simulated participants are not grouped with real ones, nor runs on a simulated ball with
    // those on a real one.
    const auto rank = [](const AnalysedRun& of) {
      return of.run.header().simulated_person ? 0 : of.is_rehearsal() ? 1 : 2;
    };
    run.in_group = run.analysis.threshold && !run.excluded &&
                   std::none_of(all.begin(), all.end(), [&](const AnalysedRun& other) {
                     return !other.excluded && rank(other) > rank(run) && same(other, run);
                   });
  }
  // Sorted by run: the last finished one of each replaces those before.
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i && all[i].in_group; ++j)
      if (all[j].name.participant == all[i].name.participant && same(all[j], all[i]))
        all[j].in_group = false;
  }
}

std::vector<AnalysedGroup> groups_of(const StudyFolder& study,
                                     const std::vector<AnalysedRun>& runs) {
  std::vector<std::string> names = study.plan().experiments;
  for (const AnalysedRun& run : runs)
    if (std::find(names.begin(), names.end(), run.name.experiment) == names.end())
      names.push_back(run.name.experiment);
  std::vector<AnalysedGroup> groups;
  for (const std::string& name : names) {
    const std::size_t first = groups.size();
    for (const AnalysedRun& run : runs) {
      if (!run.in_group || run.name.experiment != name) continue;
      const Experiment& experiment = run.run.header().experiment;
      const auto place =
          std::find_if(groups.begin() + static_cast<std::ptrdiff_t>(first), groups.end(),
                       [&](const AnalysedGroup& g) { return g.experiment == experiment; });
      AnalysedGroup& group = place != groups.end() ? *place : groups.emplace_back();
      group.experiment = experiment;
      group.runs.push_back(&run);
      group.flagged += run.analysis.flags.empty() ? 0 : 1;
    }
  }
  for (AnalysedGroup& group : groups) {
    std::vector<double> thresholds;
    std::vector<double> forces;
    for (const AnalysedRun* run : group.runs) {
      thresholds.push_back(*run->analysis.threshold);
      forces.push_back(run->analysis.force_n.value_or(0.0));
    }
    group.result = study::group(thresholds);
    group.force_n = mean(forces);
  }
  return groups;
}

}  // namespace hedgehog::study
