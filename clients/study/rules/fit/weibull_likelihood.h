// SPDX-License-Identifier: MIT
// Likelihood of a run's responses for a Weibull curve.
#pragma once

#include <span>
#include <vector>

#include "clients/study/rules/observer.h"

namespace hedgehog::study {

struct Judgement {
  double level = 0.0;  // in the experiment's unit
  bool positive = false;
};

/// The log likelihood of two parameters, both as natural logarithms: the location, which is the
/// level where F reaches `share`, and the slope. Guess and lapse rates are given.
class WeibullLikelihood {
 public:
  /// REQUIRES: 0 < share < 1, guess + lapse < 1.
  WeibullLikelihood(std::span<const Judgement> judgements, double guess, double lapse,
                    double share);

  double operator()(double log_location, double log_slope) const;

 private:
  /// Responses at one level: a run has few levels, so the sum is short.
  struct Count {
    double log_level = 0.0;  // only where level > 0
    bool zero = false;
    double positives = 0.0;
    double negatives = 0.0;
  };
  std::vector<Count> counts_{};
  double guess_;
  double span_;
  double rate_;
};

}  // namespace hedgehog::study
