// SPDX-License-Identifier: MIT
#include "clients/study/rules/weibull_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hedgehog::study {

namespace {

constexpr double kSlopeLow = 0.5;
constexpr double kSlopeHigh = 10.0;
constexpr double kMinProbability = 1e-9;

/// One level as often as it was judged: a run has few levels, so the sum is short.
struct Count {
  double log_level = 0.0;  // only where level > 0
  bool zero = false;
  double positives = 0.0;
  double negatives = 0.0;
};

std::vector<Count> counted(std::span<const Judgement> judgements) {
  std::vector<Judgement> sorted(judgements.begin(), judgements.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const Judgement& a, const Judgement& b) { return a.level < b.level; });
  std::vector<Count> counts;
  double last = -1.0;
  for (const Judgement& judgement : sorted) {
    if (counts.empty() || judgement.level > last) {
      last = judgement.level;
      counts.push_back({judgement.level > 0.0 ? std::log(judgement.level) : 0.0,
                        judgement.level <= 0.0, 0.0, 0.0});
    }
    (judgement.positive ? counts.back().positives : counts.back().negatives) += 1.0;
  }
  return counts;
}

class Likelihood {
 public:
  Likelihood(std::span<const Judgement> judgements, double guess, double lapse, double share)
      : counts_(counted(judgements)),
        guess_(guess),
        span_(1.0 - guess - lapse),
        rate_(-std::log1p(-share)) {}

  double operator()(double log_threshold, double log_slope) const {
    const double slope = std::exp(log_slope);
    double sum = 0.0;
    for (const Count& count : counts_) {
      double p = guess_;
      if (!count.zero)
        p += span_ * -std::expm1(-rate_ * std::exp(slope * (count.log_level - log_threshold)));
      p = std::clamp(p, kMinProbability, 1.0 - kMinProbability);
      sum += count.positives * std::log(p) + count.negatives * std::log1p(-p);
    }
    return sum;
  }

 private:
  std::vector<Count> counts_;
  double guess_;
  double span_;
  double rate_;
};

struct Box {
  double threshold_low, threshold_high, slope_low, slope_high;
};

struct Point {
  double threshold = 0.0;
  double slope = 0.0;
  double value = 0.0;
};

constexpr int kGrid = 12;
constexpr int kRounds = 12;

/// The best of a grid, then of ever finer grids around the best: slow but sure, whatever ridges
/// the likelihood has.
Point best_in(const Likelihood& likelihood, const Box& whole) {
  Box box = whole;
  Point best{0.0, 0.0, -INFINITY};
  for (int round = 0; round < kRounds; ++round) {
    const int cells = round == 0 ? 2 * kGrid : 4;
    const double wide = (box.threshold_high - box.threshold_low) / cells;
    const double high = (box.slope_high - box.slope_low) / cells;
    for (int i = 0; i <= cells; ++i) {
      for (int j = 0; j <= cells; ++j) {
        const double t = box.threshold_low + wide * i;
        const double s = box.slope_low + high * j;
        const double value = likelihood(t, s);
        if (value > best.value) best = {t, s, value};
      }
    }
    box.threshold_low = std::max(whole.threshold_low, best.threshold - wide);
    box.threshold_high = std::min(whole.threshold_high, best.threshold + wide);
    box.slope_low = std::max(whole.slope_low, best.slope - high);
    box.slope_high = std::min(whole.slope_high, best.slope + high);
  }
  return best;
}

}  // namespace

WeibullFit fit_weibull(const Experiment& experiment, std::span<const Judgement> judgements,
                       double guess, double lapse) {
  const double ceiling = to_value(experiment.rule.ceiling, experiment.decimals());
  const double share = share_at_threshold(experiment.task);
  const Likelihood likelihood(judgements, guess, lapse, share);
  const Point best = best_in(likelihood, {std::log(ceiling / 1000.0), std::log(ceiling),
                                          std::log(kSlopeLow), std::log(kSlopeHigh)});
  WeibullFit fit;
  fit.observer = {
      Curve::kWeibull, std::exp(best.threshold), std::exp(best.slope), guess, lapse, share};
  fit.threshold = fit.observer.level_at(convergence_point(experiment.rule));
  fit.log_likelihood = best.value;
  return fit;
}

}  // namespace hedgehog::study
