// SPDX-License-Identifier: MIT
#include "clients/study/rules/fit/weibull_likelihood.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::study {

namespace {

constexpr double kMinProbability = 1e-9;

}  // namespace

WeibullLikelihood::WeibullLikelihood(std::span<const Judgement> judgements, double guess,
                                     double lapse, double share)
    : guess_(guess), span_(1.0 - guess - lapse), rate_(-std::log1p(-share)) {
  std::vector<Judgement> sorted(judgements.begin(), judgements.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const Judgement& a, const Judgement& b) { return a.level < b.level; });
  double last = -1.0;
  for (const Judgement& judgement : sorted) {
    if (counts_.empty() || judgement.level > last) {
      last = judgement.level;
      counts_.push_back({judgement.level > 0.0 ? std::log(judgement.level) : 0.0,
                         judgement.level <= 0.0, 0.0, 0.0});
    }
    (judgement.positive ? counts_.back().positives : counts_.back().negatives) += 1.0;
  }
}

double WeibullLikelihood::operator()(double log_location, double log_slope) const {
  const double slope = std::exp(log_slope);
  double sum = 0.0;
  for (const Count& count : counts_) {
    double p = guess_;
    if (!count.zero)
      p += span_ * -std::expm1(-rate_ * std::exp(slope * (count.log_level - log_location)));
    p = std::clamp(p, kMinProbability, 1.0 - kMinProbability);
    sum += count.positives * std::log(p) + count.negatives * std::log1p(-p);
  }
  return sum;
}

}  // namespace hedgehog::study
