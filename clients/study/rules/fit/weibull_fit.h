// SPDX-License-Identifier: MIT
// A psychometric curve through all scored trials of a run, beside the mean of its reversals.
#pragma once

#include <optional>
#include <span>

#include "clients/study/rules/fit/weibull_likelihood.h"

namespace hedgehog::study {

/// Slopes are looked for between these, thresholds between the experiment's ceiling / 1000 and its
/// ceiling.
inline constexpr double kMinSlope = 0.5;
inline constexpr double kMaxSlope = 10.0;

struct WeibullFit {
  /// The curve; its guess and lapse rates are those that were assumed.
  Observer observer{};
  /// Where it reaches the rule's convergence point (80.35 %).
  double threshold = 0.0;
  double log_likelihood = 0.0;
  /// The maximum lies on a bound of the search: the answers do not tell how far beyond it the
  /// slope, or the observer's threshold, would be.
  bool slope_at_bound = false;
  bool threshold_at_bound = false;
};

/// Maximum likelihood over threshold and slope. The guess and lapse rates are not fitted: the run
/// is too short for that. REQUIRES: 0 <= guess, 0 <= lapse, guess + lapse < 1.
WeibullFit fit_weibull(const Experiment& experiment, std::span<const Judgement> judgements,
                       double guess, double lapse);

/// A range of thresholds (where the curve reaches the rule's convergence point).
struct Interval {
  double low = 0.0;
  double high = 0.0;
  /// That end is where the search ends (ceiling / 1000, ceiling): the answers set no limit there.
  bool low_is_bound = false;
  bool high_is_bound = false;
  bool contains(double threshold) const noexcept { return low <= threshold && threshold <= high; }
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// The thresholds that the answers do not contradict at 95 %: the profile of the likelihood over
/// the slope. Its coverage is in the README. Nothing where the guess rate lies beyond the
/// convergence point, so that no curve comes to it.
std::optional<Interval> profile_interval(const Experiment& experiment,
                                         std::span<const Judgement> judgements,
                                         const WeibullFit& fit);

}  // namespace hedgehog::study
