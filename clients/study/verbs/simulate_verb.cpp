// SPDX-License-Identifier: MIT
#include "clients/study/verbs/simulate_verb.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "clients/study/experiment_file.h"
#include "clients/study/rules/simulation.h"
#include "clients/study/verbs/trace_verb.h"

namespace hedgehog::study {

namespace {

using nlohmann::ordered_json;

constexpr std::array kSteps{0.02, 0.1, 0.2, 0.3, 0.5, 1.0};
constexpr int kManyReversals = 20'000;

ordered_json as_json(const Experiment& experiment, const SimulationSummary& s) {
  return {{"experiment", experiment.name},
          {"unit", experiment.unit()},
          {"observers", s.observers},
          {"finished", s.finished},
          {"true_mean", s.true_mean},
          {"estimate_mean", s.estimate_mean},
          {"estimate_sd", s.estimate_sd},
          {"bias", s.bias},
          {"relative_bias_median", s.relative_bias_median},
          {"error_sd", s.error_sd},
          {"error_5", s.error_5},
          {"error_95", s.error_95},
          {"positive_at_estimate_median", s.positive_at_estimate_median},
          {"correlation", s.correlation},
          {"trials_mean", s.trials_mean},
          {"trials_sd", s.trials_sd},
          {"trials_5", s.trials_5},
          {"trials_50", s.trials_50},
          {"trials_95", s.trials_95},
          {"trials_most", s.max_trials},
          {"minutes_mean", s.minutes_mean},
          {"floor_share", s.floor_share},
          {"floor_before_first_reversal_share", s.floor_before_first_reversal_share},
          {"ceiling_share", s.ceiling_share},
          {"rmse_reversals", s.rmse},
          {"rmse_weibull_fit", s.fit_rmse},
          {"interval_coverage", s.interval_coverage}};
}

void print(const Experiment& experiment, const SimulationSummary& s, double seconds) {
  const char* unit = experiment.unit();
  std::printf("%s, %d of %d simulated people finished, %.1f s\n", experiment.name.c_str(),
              s.finished, s.observers, seconds);
  std::printf("  estimate      %.4g ± %.3g %s (true %.4g), bias %+.2g, median %+.1f %%\n",
              s.estimate_mean, s.estimate_sd, unit, s.true_mean, s.bias,
              100.0 * s.relative_bias_median);
  std::printf("  error         sd %.3g, 5..95 %%: %+.2g .. %+.2g, r = %.2f\n", s.error_sd,
              s.error_5, s.error_95, s.correlation);
  std::printf("  at estimate   %.1f %% positive (median)\n", 100.0 * s.positive_at_estimate_median);
  std::printf("  trials        %.1f, 5/50/95 %%: %.0f/%.0f/%.0f, most %.0f; %.1f min\n",
              s.trials_mean, s.trials_5, s.trials_50, s.trials_95, s.max_trials, s.minutes_mean);
  std::printf("  floor         %.1f %%, before the first reversal %.1f %%; ceiling %.1f %%\n",
              100.0 * s.floor_share, 100.0 * s.floor_before_first_reversal_share,
              100.0 * s.ceiling_share);
  std::printf("  rmse          mean of reversals %.3g, Weibull fit %.3g\n", s.rmse, s.fit_rmse);
  std::printf("  95 %% interval of the fit holds the true point in %.1f %%\n\n",
              100.0 * s.interval_coverage);
}

ordered_json convergence_of(const Experiment& experiment, const SimulateOptions& options) {
  ordered_json rows = ordered_json::array();
  for (const double step : kSteps) {
    rows.push_back({{"step_over_spread", step},
                    {"positive", long_run_convergence(experiment.rule, experiment.task, step,
                                                      kManyReversals, options.seed)}});
  }
  return rows;
}

void print_convergence(const Experiment& experiment, const ordered_json& rows) {
  std::printf("%s converges on %.2f %% for small steps. In the long run, logistic curve,\n",
              experiment.name.c_str(), 100.0 * convergence_point(experiment.rule));
  std::printf("  step / spread (1..99 %%) ");
  for (const auto& row : rows) std::printf(" %5.2f", row["step_over_spread"].get<double>());
  std::printf("\n  %% positive at the mean  ");
  for (const auto& row : rows) std::printf(" %5.1f", 100.0 * row["positive"].get<double>());
  std::puts("\n");
}

}  // namespace

int run_simulate(const SimulateOptions& options) {
  std::vector<std::string> names = options.experiments;
  if (names.empty()) names = {"force-threshold", "force-jnd", "speed-jnd"};
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  ordered_json all = ordered_json::array();
  for (const std::string& wanted : names) {
    const auto experiment = find_experiment(wanted);
    if (!experiment) return report_error(experiment.error().exit_code, experiment.error().message);
    const auto begin = std::chrono::steady_clock::now();
    const auto runs = simulate(
        *experiment, thesis_population(experiment->quantity),
        {options.observers, options.seed, options.threads > 0 ? options.threads : cores, true});
    const SimulationSummary summary = summarise(*experiment, runs);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    all.push_back(as_json(*experiment, summary));
    if (!options.json) print(*experiment, summary, took.count());
    if (options.convergence) {
      all.back()["convergence"] = convergence_of(*experiment, options);
      if (!options.json) print_convergence(*experiment, all.back()["convergence"]);
    }
  }
  if (options.json) std::puts(all.dump().c_str());
  return 0;
}

}  // namespace hedgehog::study
