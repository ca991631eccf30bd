// SPDX-License-Identifier: MIT
// A psychometric curve fitted to all scored trials of a run, in addition to the mean of its
// reversals.
#pragma once

#include <optional>
#include <span>

#include "clients/study/rules/fit/weibull_likelihood.h"

namespace hedgehog::study {

/// Bounds of the slope; the threshold is bounded by the experiment's ceiling / 1000 and its
/// ceiling.
inline constexpr double kMinSlope = 0.5;
inline constexpr double kMaxSlope = 10.0;

struct WeibullFit {
  /// The curve, with the assumed guess and lapse rates.
  Observer observer{};
  /// Level at the rule's convergence point (80.35 %).
  double threshold = 0.0;
  double log_likelihood = 0.0;
  /// The maximum lies on a bound of the search: the responses do not determine how far beyond it
  /// the slope, or the observer's threshold, lies.
  bool slope_at_bound = false;
  bool threshold_at_bound = false;
};

/// Maximum likelihood over threshold and slope. The guess and lapse rates are not fitted: the run
/// is too short for that. REQUIRES: 0 <= guess, 0 <= lapse, guess + lapse < 1.
WeibullFit fit_weibull(const Experiment& experiment, std::span<const Judgement> judgements,
                       double guess, double lapse);

/// A range of thresholds (levels at the rule's convergence point).
struct Interval {
  double low = 0.0;
  double high = 0.0;
  /// That end is a bound of the search (ceiling / 1000, ceiling): the responses do not limit it.
  bool low_is_bound = false;
  bool high_is_bound = false;
  bool contains(double threshold) const noexcept { return low <= threshold && threshold <= high; }
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// The thresholds that are consistent with the responses at 95 %: by profile likelihood over the
/// slope. Its coverage is in the README. nullopt if the guess rate is above the convergence point,
/// which no curve then reaches.
std::optional<Interval> profile_interval(const Experiment& experiment,
                                         std::span<const Judgement> judgements,
                                         const WeibullFit& fit);

}  // namespace hedgehog::study
