// SPDX-License-Identifier: MIT
#include "clients/study/rules/simulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "clients/study/rules/statistics.h"

namespace hedgehog::study {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kYesNoSeconds = 8.0;
constexpr double kTwoIntervalSeconds = 14.0;
constexpr double kThesisPatternSeconds = 5.0;
constexpr double kSecondsAMinute = 60.0;

}  // namespace

SimulatedRun simulate_run(const Experiment& experiment, const Observer& observer,
                          std::uint64_t seed, std::uint64_t number, bool with_fit) {
  SimulatedRun run;
  run.observer = observer;
  run.true_point = observer.level_at(convergence_point(experiment.rule));
  run.estimate = kNone;
  run.fitted = kNone;
  const std::uint64_t own_seed =
      draw_bits(seed, Purpose::kSeed, {word_of(experiment.name), number});
  Staircase staircase(experiment.rule);
  while (!staircase.over()) {
    const double level = to_value(staircase.level(), experiment.decimals());
    const bool positive = simulated_answer(observer, level, own_seed, word_of(experiment.name),
                                           staircase.state().scored + 1);
    run.judgements.push_back({level, positive});
    run.positives += positive ? 1 : 0;
    staircase.answer(positive);
    if (staircase.level() == experiment.rule.floor) {
      run.floor_hit = true;
      run.floor_before_first_reversal |= staircase.state().reversals.empty();
    }
  }
  run.scored = staircase.state().scored;
  run.ceiling_hit = staircase.state().ceiling_hits > 0;
  run.status = staircase.status();
  if (const auto counted = staircase.counted_reversals(); !counted.empty())
    run.estimate = mean_value(counted, experiment.decimals());
  if (with_fit) {
    const WeibullFit fit = fit_weibull(experiment, run.judgements, observer.guess, observer.lapse);
    run.fitted = fit.threshold;
    run.interval = profile_interval(experiment, run.judgements, fit);
  }
  return run;
}

double trial_seconds(const Experiment& experiment) noexcept {
  const double longer =
      static_cast<double>(experiment.pattern.duration_ms) / 1000.0 - kThesisPatternSeconds;
  return experiment.task == Task::kYesNo ? kYesNoSeconds + longer
                                         : kTwoIntervalSeconds + 2.0 * longer;
}

std::vector<SimulatedRun> simulate(const Experiment& experiment, const Population& population,
                                   const SimulationOptions& options) {
  const int threads = std::max(1, options.threads);
  std::vector<SimulatedRun> runs(static_cast<std::size_t>(options.observers));
  const auto work = [&](std::size_t first) {
    for (std::size_t i = first; i < runs.size(); i += static_cast<std::size_t>(threads)) {
      const Observer observer = drawn_observer(experiment, population, options.seed, i);
      runs[i] = simulate_run(experiment, observer, options.seed, i, options.with_fit);
    }
  };
  std::vector<std::jthread> workers;
  for (int t = 1; t < threads; ++t) workers.emplace_back(work, static_cast<std::size_t>(t));
  work(0);
  workers.clear();
  return runs;
}

SimulationSummary summarise(const Experiment& experiment, const std::vector<SimulatedRun>& runs) {
  SimulationSummary summary;
  std::vector<double> truths;
  std::vector<double> estimates;
  std::vector<double> errors;
  std::vector<double> relative;
  std::vector<double> trials;
  std::vector<double> positive;
  double squares = 0.0;
  double fit_squares = 0.0;
  double covered = 0.0;
  double floor = 0.0;
  double early_floor = 0.0;
  double ceiling = 0.0;
  for (const SimulatedRun& run : runs) {
    floor += run.floor_hit ? 1.0 : 0.0;
    early_floor += run.floor_before_first_reversal ? 1.0 : 0.0;
    ceiling += run.ceiling_hit ? 1.0 : 0.0;
    trials.push_back(run.scored);
    if (run.status != Status::kFinished) continue;
    const double error = run.estimate - run.true_point;
    truths.push_back(run.true_point);
    estimates.push_back(run.estimate);
    errors.push_back(error);
    relative.push_back(error / run.true_point);
    positive.push_back(run.observer.positive_at(run.estimate));
    squares += error * error;
    fit_squares += (run.fitted - run.true_point) * (run.fitted - run.true_point);
    covered += run.interval && run.interval->contains(run.true_point) ? 1.0 : 0.0;
  }
  const double all = std::max<double>(1.0, static_cast<double>(runs.size()));
  summary.observers = static_cast<int>(runs.size());
  summary.finished = static_cast<int>(estimates.size());
  summary.floor_share = floor / all;
  summary.floor_before_first_reversal_share = early_floor / all;
  summary.ceiling_share = ceiling / all;
  if (estimates.empty()) return summary;
  const double count = static_cast<double>(estimates.size());
  summary.true_mean = mean(truths);
  summary.estimate_mean = mean(estimates);
  summary.estimate_sd = standard_deviation(estimates);
  summary.bias = mean(errors);
  summary.relative_bias_median = quantile(relative, 0.5);
  summary.error_sd = standard_deviation(errors);
  summary.error_5 = quantile(errors, 0.05);
  summary.error_95 = quantile(errors, 0.95);
  summary.positive_at_estimate_median = quantile(positive, 0.5);
  summary.correlation = correlation(truths, estimates);
  summary.trials_mean = mean(trials);
  summary.trials_sd = standard_deviation(trials);
  summary.trials_5 = quantile(trials, 0.05);
  summary.trials_50 = quantile(trials, 0.5);
  summary.trials_95 = quantile(trials, 0.95);
  summary.max_trials = quantile(trials, 1.0);
  summary.minutes_mean = summary.trials_mean * trial_seconds(experiment) / kSecondsAMinute;
  summary.rmse = std::sqrt(squares / count);
  summary.fit_rmse = std::sqrt(fit_squares / count);
  summary.interval_coverage = covered / count;
  return summary;
}

double long_run_convergence(const StaircaseRule& rule, Task task, double step, int reversals,
                            std::uint64_t seed) {
  // The 1 % and 99 % points of a logistic curve are 2 ln 99 of its units apart.
  constexpr Level kSpread = 1'000'000'000;
  const double unit = static_cast<double>(kSpread) / (2.0 * std::log(99.0));
  const Stage& last = rule.stages.back();
  const double ratio = static_cast<double>(last.step_down) / static_cast<double>(last.step_up);
  const Level up = std::llround(step * static_cast<double>(kSpread));
  StaircaseRule endless = rule;
  endless.start = kSpread / 2;
  endless.floor = -1000 * kSpread;
  endless.ceiling = 1000 * kSpread;
  endless.stages = {{up, std::llround(ratio * static_cast<double>(up)), reversals}};
  endless.max_trials = std::numeric_limits<int>::max();
  const double guess = task == Task::kYesNo ? 0.0 : 0.5;
  const auto psi = [&](double level) {
    return guess + (1.0 - guess) / (1.0 + std::exp(-level / unit));
  };
  Staircase staircase(endless);
  while (!staircase.over()) {
    const auto trial = static_cast<std::uint64_t>(staircase.state().scored) + 1;
    staircase.answer(draw(seed, Purpose::kAnswer, {trial}) <
                     psi(static_cast<double>(staircase.level())));
  }
  return psi(mean_value(staircase.counted_reversals(), 0));
}

}  // namespace hedgehog::study
