// SPDX-License-Identifier: MIT
// Simulated people with one staircase: the error of the method itself.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "clients/study/rules/fit/weibull_fit.h"
#include "clients/study/rules/observer.h"
#include "clients/study/rules/staircase.h"

namespace hedgehog::study {

/// One simulated run. NaN for missing values.
struct SimulatedRun {
  Observer observer{};
  double true_point = 0.0;  // the level at the rule's convergence point
  double estimate = 0.0;    // mean of the counted reversals
  double fitted = 0.0;      // threshold of the Weibull fit with the true guess and lapse rates
  std::optional<Interval> interval{};  // the fit's, 95 %
  int scored = 0;
  bool floor_hit = false;
  bool floor_before_first_reversal = false;
  bool ceiling_hit = false;
  int positives = 0;
  Status status = Status::kIncomplete;
  std::vector<Judgement> judgements{};
};

/// Pure: the same result for the same arguments, on any thread.
SimulatedRun simulate_run(const Experiment& experiment, const Observer& observer,
                          std::uint64_t seed, std::uint64_t number, bool with_fit);

struct SimulationOptions {
  int observers = 2000;
  std::uint64_t seed = 2026;
  int threads = 1;
  bool with_fit = true;
};

/// Statistics of a campaign; errors are estimate minus true point.
struct SimulationSummary {
  int observers = 0;
  int finished = 0;
  double true_mean = 0.0;
  double estimate_mean = 0.0;
  double estimate_sd = 0.0;
  double bias = 0.0;
  double relative_bias_median = 0.0;
  double error_sd = 0.0;
  double error_5 = 0.0;
  double error_95 = 0.0;
  double positive_at_estimate_median = 0.0;
  double correlation = 0.0;
  double trials_mean = 0.0;
  double trials_sd = 0.0;
  double trials_5 = 0.0;
  double trials_50 = 0.0;
  double trials_95 = 0.0;
  double max_trials = 0.0;
  double minutes_mean = 0.0;
  double floor_share = 0.0;
  double floor_before_first_reversal_share = 0.0;
  double ceiling_share = 0.0;
  double rmse = 0.0;
  double fit_rmse = 0.0;
  /// The share of the fits' 95 % intervals that contain the true point.
  double interval_coverage = 0.0;
};

/// Duration of a trial with presentation, response and the pause to the next, s: 8 for one
/// presentation, 14 for two (assumed, for 5 s patterns; adjusted for other durations).
double trial_seconds(const Experiment& experiment) noexcept;

std::vector<SimulatedRun> simulate(const Experiment& experiment, const Population& population,
                                   const SimulationOptions& options);
SimulationSummary summarise(const Experiment& experiment, const std::vector<SimulatedRun>& runs);

/// The psychometric value at the mean of `reversals` reversals of an endless run with a constant
/// step of `step` x the spread from the 1 % to the 99 % point of a logistic curve on an unbounded
/// linear axis: the convergence point of the rule.
double long_run_convergence(const StaircaseRule& rule, Task task, double step, int reversals,
                            std::uint64_t seed);

}  // namespace hedgehog::study
