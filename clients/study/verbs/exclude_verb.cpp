// SPDX-License-Identifier: MIT
#include "clients/study/verbs/exclude_verb.h"

#include <cstdio>
#include <optional>

#include "clients/study/exclusions.h"
#include "clients/study/journal/journal.h"
#include "clients/study/verbs/trace_verb.h"

namespace hedgehog::study {

namespace {

std::string text_of(const JournalName& name) {
  return name.participant + " " + name.experiment + " " + std::to_string(name.run);
}

int report_problem(const Problem& problem) {
  return report_error(problem.exit_code, problem.message);
}

/// Calls `change` with the selected run and the present exclusions; returns its exit code.
template <class Change>
int changed(const ExcludeOptions& options, Change change) {
  const auto study = StudyFolder::find(".");
  if (!study) return report_problem(study.error());
  std::optional<JournalName> wanted;
  for (const JournalName& name : study->journals())
    if (name.participant == options.participant && name.experiment == options.experiment &&
        (options.run == 0 || name.run == options.run) && has_begun(name.path))
      wanted = name;  // by run: the last
  if (!wanted) {
    return report_error(EX_NOINPUT, options.participant + " has no run " +
                                        (options.run > 0 ? std::to_string(options.run) + " " : "") +
                                        "of " + options.experiment +
                                        "; hedgehog-study status shows all");
  }
  auto exclusions = Exclusions::read(*study);
  if (!exclusions) return report_problem(exclusions.error());
  return change(*wanted, *exclusions);
}

}  // namespace

int run_exclude(const ExcludeOptions& options) {
  return changed(
      options,
      [&](const JournalName& name, Exclusions& exclusions) {
        exclusions.add({name.participant, name.experiment, name.run, options.reason, utc_now()});
        if (const auto written = exclusions.write(); !written)
          return report_problem(written.error());
        std::printf("%s is excluded: %s\n", text_of(name).c_str(), options.reason.c_str());
        return 0;
      });
}

int run_include(const ExcludeOptions& options) {
  return changed(
      options,
      [&](const JournalName& name, Exclusions& exclusions) {
        if (!exclusions.remove(name))
          return report_error(EX_NOINPUT, text_of(name) + " is not excluded");
        if (const auto written = exclusions.write(); !written)
          return report_problem(written.error());
        std::printf("%s counts again\n", text_of(name).c_str());
        return 0;
      });
}

}  // namespace hedgehog::study
