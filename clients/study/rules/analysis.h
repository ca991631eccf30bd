// SPDX-License-Identifier: MIT
// Result of a run, and its reliability.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/study/rules/run.h"

namespace hedgehog::study {

/// Warnings about a run. A finished run is not necessarily valid: random responses finish too.
enum class Flag : std::uint8_t {
  kNotFinished,
  kCeiling,       // the level was clamped to its maximum
  kEarlyFloor,    // the level reached its minimum before any reversal
  kFalseAlarms,   // yes in more than one of five catch trials
  kGuessing,      // correct no more often than by chance (5 %), two intervals only
  kZeroLevel,     // a scored yes/no trial was at 0 A
  kDisagreement,  // the threshold lies outside of the fitted curve's 95 % interval
};

/// "early floor", for tables; and one sentence for a report.
const char* name(Flag flag) noexcept;
const char* meaning(Flag flag) noexcept;

struct AnalysisOptions {
  /// Assumed in the fit, not fitted.
  double lapse = 0.02;
  double false_alarm = 0.02;  // yes/no without catch trials
  /// Force constant of the ball used, N/A at the nearest pin (thesis: 0.0126).
  double force_n_per_a = 0.0126;
};

struct RunAnalysis {
  Status status = Status::kIncomplete;
  int scored = 0;
  /// By the thesis' rule: mean of all reversals but the first two, in the experiment's unit; and as
  /// exact decimal text. nullopt unless finished.
  std::optional<double> threshold{};
  std::optional<std::string> threshold_text{};
  /// Standard deviation of the counted reversals.
  double reversal_sd = 0.0;
  /// Fitted to all scored trials.
  std::optional<WeibullFit> fit{};
  /// 95 % interval of the fitted curve's threshold, by profile likelihood.
  std::optional<Interval> interval{};
  /// (test - reference) / reference; two intervals only.
  std::optional<double> weber_fraction{};
  /// Force at the threshold (yes/no), or force step (force JND), N.
  std::optional<double> force_n{};
  std::vector<Flag> flags{};
};

RunAnalysis analyse(const Experiment& experiment, const RunState& run,
                    const AnalysisOptions& options);

struct GroupResult {
  int count = 0;
  double mean = 0.0;
  double sd = 0.0;  // n - 1
};
GroupResult group(const std::vector<double>& thresholds);

}  // namespace hedgehog::study
