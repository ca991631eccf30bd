// SPDX-License-Identifier: MIT
// `plan`, `run`, `resume`, `rehearse`, `status`, `participant`: verbs that work on a study's
// folder.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clients/study/journal/event.h"

namespace hedgehog::study {

struct PlanOptions {
  std::string folder{};
  int participants = 10;
  std::uint64_t seed = 2026;
  std::vector<std::string> experiments{"force-threshold", "force-jnd", "speed-jnd"};
};
int run_plan(const PlanOptions& options);

struct RunOptions {
  std::optional<std::string> address{};
  std::string experiment{};
  std::string participant{};
  /// Entries given on the command line; the experimenter is asked for the rest.
  Checklist checklist{};
  bool simulated = false;
  bool again = false;
  bool blind = false;
};
int run_run(const RunOptions& options);
/// The unfinished run of `participant` and `experiment` (empty: the most recently modified).
int run_resume(const RunOptions& options);
/// Every participant through every experiment, with simulated responses; resumes unfinished runs.
int run_rehearse(const RunOptions& options);
int run_status(bool json);
int run_participant();

}  // namespace hedgehog::study
