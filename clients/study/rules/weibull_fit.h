// SPDX-License-Identifier: MIT
// A psychometric curve through all scored trials of a run, beside the mean of its reversals.
#pragma once

#include <span>

#include "clients/study/rules/observer.h"

namespace hedgehog::study {

struct Judgement {
  double level = 0.0;  // in the experiment's unit
  bool positive = false;
};

struct WeibullFit {
  /// The curve; its guess and lapse rates are those that were assumed.
  Observer observer{};
  /// Where it reaches the rule's convergence point (80.35 %).
  double threshold = 0.0;
  double log_likelihood = 0.0;
};

/// Maximum likelihood over threshold and slope (0.5 to 10). The guess and lapse rates are not
/// fitted: the run is too short for that. Thresholds are looked for between `ceiling`/1000 and
/// `ceiling`.
WeibullFit fit_weibull(const Experiment& experiment, std::span<const Judgement> judgements,
                       double guess, double lapse);

}  // namespace hedgehog::study
