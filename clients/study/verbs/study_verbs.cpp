// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "clients/study/exclusions.h"
#include "clients/study/experiment_file.h"
#include "clients/study/journal/journal.h"
#include "clients/study/study_folder.h"
#include "clients/study/verbs/run_verb.h"
#include "clients/study/verbs/trace_verb.h"

namespace hedgehog::study {

namespace {

using nlohmann::ordered_json;

std::string run_summary(const RecordedRun& run) {
  const Experiment& experiment = run.header().experiment;
  const Staircase& staircase = run.state().staircase();
  const auto counted = staircase.counted_reversals();
  if (!counted.empty())
    return fmt::format("{:.3g} {}", mean_value(counted, experiment.decimals()), experiment.unit());
  return run.over() ? "given up" : fmt::format("open, {} trials", staircase.state().scored);
}

void add_missing(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

ordered_json as_json(const JournalName& name, const RecordedRun& run) {
  const Experiment& experiment = run.header().experiment;
  const Staircase& staircase = run.state().staircase();
  const auto counted = staircase.counted_reversals();
  return {
      {"participant", name.participant},
      {"experiment", name.experiment},
      {"run", name.run},
      {"status", study::name(staircase.status())},
      {"scored", staircase.state().scored},
      {"voids", run.state().voids()},
      {"reversals", staircase.state().reversals.size()},
      {"threshold", counted.empty() ? ordered_json(nullptr)
                                    : ordered_json(mean_decimal(counted, experiment.decimals()))},
      {"unit", experiment.unit()},
      {"journal", name.path.string()}};
}

}  // namespace

int run_plan(const PlanOptions& options) {
  std::vector<std::string> names;
  std::vector<std::filesystem::path> files;
  for (const std::string& given : options.experiments) {
    const auto experiment = find_experiment(given);
    if (!experiment) return report_error(experiment.error().exit_code, experiment.error().message);
    if (const auto checked = is_no_other_preset(*experiment); !checked)
      return report_error(checked.error().exit_code, checked.error().message);
    for (const std::string& before : names) {
      if (bids_label(before) == bids_label(experiment->name)) {
        return report_error(
            EX_USAGE,
            given + ": " + experiment->name +
                (before == experiment->name ? " is in the plan already"
                                            : " would be taken for " + before +
                                                  " in an export to BIDS: give it another name"));
      }
    }
    names.push_back(experiment->name);
    if (given != experiment->name) files.emplace_back(given);
  }
  const StudyPlan plan = make_plan(options.participants, names, options.seed);
  const auto study = StudyFolder::create(options.folder, plan, files);
  if (!study) return report_error(study.error().exit_code, study.error().message);
  std::printf("%s/study.json: %d people x %zu experiments, Latin square, seeds drawn\n",
              options.folder.c_str(), options.participants, options.experiments.size());
  for (const Participant& participant : plan.participants) {
    std::printf("  %s ", participant.id.c_str());
    for (const std::string& experiment : participant.order) std::printf(" %s", experiment.c_str());
    std::puts("");
  }
  const std::size_t orders = latin_square(static_cast<int>(names.size())).size();
  if (plan.participants.size() % orders != 0)
    std::printf("  (every order equally often: a multiple of %zu people)\n", orders);
  return 0;
}

int run_status(bool json) {
  const auto study = StudyFolder::find(".");
  if (!study) return report_error(study.error().exit_code, study.error().message);
  const auto exclusions = Exclusions::read(*study);
  if (!exclusions) return report_error(exclusions.error().exit_code, exclusions.error().message);
  ordered_json all = ordered_json::array();
  std::vector<std::pair<JournalName, std::string>> cells;
  int code = 0;
  for (const JournalName& name : study->journals()) {
    if (!has_begun(name.path)) continue;  // killed before its first event
    const auto run = read_run(name.path);
    if (!run) {
      code = report_error(run.error().exit_code, run.error().message);
      cells.emplace_back(name, "damaged");
      continue;
    }
    const Exclusion* excluded = exclusions->of(name);
    all.push_back(as_json(name, *run));
    all.back()["excluded"] =
        excluded != nullptr ? ordered_json(excluded->reason) : ordered_json(nullptr);
    cells.emplace_back(name, excluded != nullptr ? "excluded" : run_summary(*run));
  }
  if (json) {
    // A folder's name may have any bytes.
    std::puts(all.dump(-1, ' ', false, ordered_json::error_handler_t::replace).c_str());
    return code;
  }
  // Those of the plan first, then additional participants and experiments.
  std::vector<std::string> experiments = study->plan().experiments;
  std::vector<std::string> people;
  for (const Participant& participant : study->plan().participants)
    people.push_back(participant.id);
  for (const auto& [name, given] : cells) {
    add_missing(experiments, name.experiment);
    add_missing(people, name.participant);
  }
  std::printf("       ");
  for (const std::string& experiment : experiments) std::printf(" %-18s", experiment.c_str());
  std::puts("");
  for (const std::string& person : people) {
    std::printf("  %-5s", person.c_str());
    for (const std::string& experiment : experiments) {
      std::string text = "-";
      for (const auto& [name, given] : cells)
        if (name.participant == person && name.experiment == experiment) text = given;
      std::printf(" %-18s", text.c_str());
    }
    std::puts("");
  }
  return code;
}

}  // namespace hedgehog::study
