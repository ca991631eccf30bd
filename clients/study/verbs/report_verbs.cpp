// SPDX-License-Identifier: MIT
#include "clients/study/verbs/report_verbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "clients/study/report/bids.h"
#include "clients/study/report/figures.h"
#include "clients/study/report/html.h"
#include "clients/study/rules/distinguishable_levels.h"
#include "clients/study/verbs/trace_verb.h"

namespace hedgehog::study {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

void print_groups(const std::vector<AnalysedGroup>& groups) {
  std::puts("                          thesis    here");
  for (const AnalysedGroup& group : groups) {
    const char* unit = group.experiment.unit();
    const std::string thesis =
        is_as_in_thesis(group.experiment)
            ? fmt::format("{:.3g} {}", thesis_result(group.experiment.quantity), unit)
            : "-";
    std::printf("  %-23s %-9s %.3g %s ± %.2g, n = %d", group.experiment.name.c_str(),
                thesis.c_str(), group.result.mean, unit, group.result.sd, group.result.count);
    if (group.force_n > 0) std::printf(", %.4f N", group.force_n);
    std::puts("");
  }
}

void print_flags(const std::vector<AnalysedRun>& runs) {
  for (const AnalysedRun& run : runs) {
    for (const Flag flag : run.analysis.flags) {
      std::printf("  %s %s: %s, %s\n", run.name.participant.c_str(), run.name.experiment.c_str(),
                  name(flag), meaning(flag));
    }
  }
}

void print_exclusions(const std::vector<AnalysedRun>& runs) {
  for (const AnalysedRun& run : runs) {
    if (run.excluded) {
      std::printf("  %s %s %d is excluded: %s\n", run.name.participant.c_str(),
                  run.name.experiment.c_str(), run.name.run, run.excluded->reason.c_str());
    }
  }
}

/// Simulated results must not be mistaken for a study's.
void warn_of_simulated(const std::vector<AnalysedRun>& runs) {
  const auto simulated = std::count_if(
      runs.begin(), runs.end(),
      [](const AnalysedRun& run) { return run.run.header().simulated_person; });
  const auto simulated_ball = std::count_if(runs.begin(), runs.end(), [](const AnalysedRun& run) {
    return !run.run.header().simulated_person && run.run.header().ball.simulated;
  });
  if (simulated_ball > 0) {
    std::fprintf(stderr,
                 "hedgehog-study: %td of %zu runs are of people on a simulated ball: they felt "
                 "nothing\n",
                 simulated_ball, runs.size());
  }
  if (simulated > 0) {
    std::fprintf(stderr,
                 "hedgehog-study: %td of %zu runs are of simulated people; where people took an "
                 "experiment, they alone make its mean\n",
                 simulated, runs.size());
  }
}

/// 0, or EX_DATAERR if data is missing from the output.
int print(const std::vector<Problem>& problems) {
  int code = 0;
  for (const Problem& problem : problems) {
    report_error(problem.exit_code, problem.message);
    code = problem.exit_code != 0 ? EX_DATAERR : code;
  }
  return code;
}

ordered_json as_json(const AnalysedRun& analysed) {
  const RunAnalysis& a = analysed.analysis;
  ordered_json flags = ordered_json::array();
  for (const Flag flag : a.flags) flags.push_back(name(flag));
  ordered_json out{{"participant", analysed.name.participant},
                   {"experiment", analysed.name.experiment},
                   {"run", analysed.name.run},
                   {"simulated_person", analysed.run.header().simulated_person},
                   {"status", name(a.status)},
                   {"scored", a.scored},
                   {"threshold", nullptr},
                   {"unit", analysed.run.header().experiment.unit()},
                   {"interval_95", nullptr},
                   {"interval_95_at_bound", nullptr},
                   {"weibull_threshold", nullptr},
                   {"weibull_slope", nullptr},
                   {"weibull_slope_at_bound", nullptr},
                   {"weibull_threshold_at_bound", nullptr},
                   {"weber_fraction", nullptr},
                   {"force_n", nullptr},
                   {"flags", flags},
                   {"in_group", analysed.in_group},
                   {"excluded", nullptr}};
  if (analysed.excluded) out["excluded"] = analysed.excluded->reason;
  if (a.threshold_text) out["threshold"] = *a.threshold_text;
  if (a.interval) {
    out["interval_95"] = {a.interval->low, a.interval->high};
    out["interval_95_at_bound"] = {a.interval->low_is_bound, a.interval->high_is_bound};
  }
  if (a.fit) {
    out["weibull_threshold"] = a.fit->threshold;
    out["weibull_slope"] = a.fit->observer.slope;
    out["weibull_slope_at_bound"] = a.fit->slope_at_bound;
    out["weibull_threshold_at_bound"] = a.fit->threshold_at_bound;
  }
  if (a.weber_fraction) out["weber_fraction"] = *a.weber_fraction;
  if (a.force_n) out["force_n"] = *a.force_n;
  return out;
}

struct AnalysedRuns {
  StudyFolder study;
  std::vector<AnalysedRun> runs;
  int code = 0;  // of the problems, which are printed
};

Result<AnalysedRuns> analysed_runs() {
  const auto study = StudyFolder::find(".");
  if (!study) return study.error();
  const auto exclusions = Exclusions::read(*study);
  if (!exclusions) return exclusions.error();
  std::vector<Problem> problems;
  auto runs = collect(*study, *exclusions, problems);
  const int code = print(problems);
  if (runs.empty()) return Problem{EX_NOINPUT, "there is no run yet"};
  return AnalysedRuns{*study, std::move(runs), code};
}

}  // namespace

int run_analyse(const AnalyseOptions& options) {
  const auto analysed = analysed_runs();
  if (!analysed) return report_error(analysed.error().exit_code, analysed.error().message);
  const auto& [study, runs, code] = *analysed;
  warn_of_simulated(runs);
  const auto groups = groups_of(study, runs);
  const fs::path out = options.out.empty() ? study.path() / "analysis" : fs::path(options.out);
  std::error_code failed;
  fs::create_directories(out / "figures", failed);
  const auto drawn = draw(out / "figures", runs, groups);
  std::ofstream page(out / "report.html", std::ios::binary);
  page << report_page(study, runs, groups, out / "figures");
  page.flush();
  if (!page)
    return report_error(EX_CANTCREAT, (out / "report.html").string() + ": cannot be written");
  if (options.json) {
    ordered_json all = ordered_json::array();
    for (const AnalysedRun& run : runs) all.push_back(as_json(run));
    std::puts(all.dump().c_str());
  } else {
    print_groups(groups);
    print_flags(runs);
    print_exclusions(runs);
    std::printf("%s\n", (out / "report.html").c_str());
  }
  if (!drawn) return report_error(drawn.error().exit_code, drawn.error().message);
  return code;
}

int run_export(const ExportOptions& options) {
  const auto analysed = analysed_runs();
  if (!analysed) return report_error(analysed.error().exit_code, analysed.error().message);
  const auto& [study, runs, code] = *analysed;
  warn_of_simulated(runs);
  const bool bids = options.format == "bids";
  const fs::path out =
      options.out.empty() ? study.path() / (bids ? "bids" : "data.csv") : fs::path(options.out);
  const auto written = bids ? write_bids(out, study, runs, options.authors) : write_csv(out, runs);
  if (!written) return report_error(written.error().exit_code, written.error().message);
  std::printf("%s: %zu runs\n", out.c_str(), runs.size());
  return code;
}

int run_levels(const LevelsOptions& options) {
  std::printf("threshold %.3g A, JND of force %.3g %%, of speed %.3g %%\n", options.threshold_a,
              options.force_percent, options.speed_percent);
  std::puts("  range             formula                                       steps  levels");
  for (const LevelFormula& row : level_formulas(options.threshold_a, options.force_percent / 100.0,
                                                options.speed_percent / 100.0)) {
    std::printf("  %-17s %-45s %5.1f  %6d\n", row.range.c_str(), row.formula.c_str(),
                row.count.steps, row.count.levels);
    if (!row.remark.empty()) std::printf("  %-17s %s\n", "", row.remark.c_str());
  }
  for (const std::string& remark : level_remarks(options.threshold_a, options.force_percent / 100.0,
                                                 options.speed_percent / 100.0))
    std::printf("  %s\n", remark.c_str());
  return 0;
}

}  // namespace hedgehog::study
