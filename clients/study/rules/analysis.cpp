// SPDX-License-Identifier: MIT
#include "clients/study/rules/analysis.h"

#include <algorithm>

#include "clients/study/rules/statistics.h"

namespace hedgehog::study {

namespace {

constexpr double kFewFalseAlarms = 0.2;
constexpr double kCoinLevel = 0.05;
constexpr double kPercent = 100.0;

bool is_guessing(const Experiment& experiment, const RunState& run) {
  if (experiment.task == Task::kYesNo || run.judgements().empty()) return false;
  const auto right = std::count_if(run.judgements().begin(), run.judgements().end(),
                                   [](const Judgement& j) { return j.positive; });
  return coin_tail(static_cast<int>(right), static_cast<int>(run.judgements().size())) > kCoinLevel;
}

std::vector<Flag> flags_of(const Experiment& experiment, const RunState& run) {
  std::vector<Flag> flags;
  const StaircaseState& state = run.staircase().state();
  const auto raise = [&](Flag flag, bool raised) {
    if (raised) flags.push_back(flag);
  };
  raise(Flag::kNotFinished, run.staircase().status() != Status::kFinished);
  raise(Flag::kCeiling, state.ceiling_hits > 0);
  raise(Flag::kEarlyFloor, run.early_floor());
  raise(Flag::kFalseAlarms, run.false_alarms() > kFewFalseAlarms * run.catches());
  raise(Flag::kGuessing, is_guessing(experiment, run));
  raise(Flag::kZeroLevel, experiment.task == Task::kYesNo &&
                              std::any_of(run.judgements().begin(), run.judgements().end(),
                                          [](const Judgement& j) { return j.level <= 0.0; }));
  return flags;
}

/// The false-alarm rate, with half an alarm and half a rejection added so that a few catch trials
/// never result in 0 or 1.
double false_alarm_rate(const RunState& run, const AnalysisOptions& options) {
  return run.catches() == 0 ? options.false_alarm
                            : (run.false_alarms() + 0.5) / (run.catches() + 1.0);
}

}  // namespace

const char* name(Flag flag) noexcept {
  switch (flag) {
    case Flag::kCeiling:
      return "ceiling";
    case Flag::kEarlyFloor:
      return "early floor";
    case Flag::kFalseAlarms:
      return "false alarms";
    case Flag::kGuessing:
      return "guessing";
    case Flag::kZeroLevel:
      return "zero level";
    case Flag::kDisagreement:
      return "fit and mean disagree";
    case Flag::kNotFinished:
      break;
  }
  return "not finished";
}

const char* meaning(Flag flag) noexcept {
  switch (flag) {
    case Flag::kCeiling:
      return "the level was held at its ceiling: the threshold may lie above it";
    case Flag::kEarlyFloor:
      return "the level reached its floor before the first reversal, by chance, as in a third of "
             "valid JND runs, or because of an unintended cue";
    case Flag::kFalseAlarms:
      return "yes in more than a fifth of the catch trials: the threshold is too low";
    case Flag::kGuessing:
      return "correct at chance level: the run is not informative";
    case Flag::kZeroLevel:
      return "a scored trial had no current at all";
    case Flag::kDisagreement:
      return "the mean of the reversals lies outside of the fitted curve's 95 %: the data do not "
             "show which of the two is correct";
    case Flag::kNotFinished:
      break;
  }
  return "too few reversals: there is no threshold";
}

RunAnalysis analyse(const Experiment& experiment, const RunState& run,
                    const AnalysisOptions& options) {
  RunAnalysis result;
  const Staircase& staircase = run.staircase();
  result.status = staircase.status();
  result.scored = staircase.state().scored;
  result.flags = flags_of(experiment, run);
  const std::vector<Level> counted = staircase.counted_reversals();
  if (counted.empty()) return result;
  result.threshold = mean_value(counted, experiment.decimals());
  result.threshold_text = mean_decimal(counted, experiment.decimals());
  std::vector<double> values;
  values.reserve(counted.size());
  for (const Level level : counted) values.push_back(to_value(level, experiment.decimals()));
  result.reversal_sd = standard_deviation(values);

  const double guess = experiment.task == Task::kYesNo ? false_alarm_rate(run, options) : 0.5;
  result.fit = fit_weibull(experiment, run.judgements(), guess, options.lapse);
  result.interval = profile_interval(experiment, run.judgements(), *result.fit);
  if (result.interval && !result.interval->contains(*result.threshold))
    result.flags.push_back(Flag::kDisagreement);
  switch (experiment.quantity) {
    case Quantity::kCurrentA:
      result.force_n = *result.threshold * options.force_n_per_a;
      break;
    case Quantity::kCurrentPercent:
      result.force_n =
          *result.threshold / kPercent * experiment.pattern.current_a * options.force_n_per_a;
      [[fallthrough]];
    case Quantity::kSpeedPercent:
      result.weber_fraction = *result.threshold / kPercent;
      break;
  }
  return result;
}

GroupResult group(const std::vector<double>& thresholds) {
  return {static_cast<int>(thresholds.size()), mean(thresholds), standard_deviation(thresholds)};
}

}  // namespace hedgehog::study
