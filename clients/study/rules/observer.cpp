// SPDX-License-Identifier: MIT
#include "clients/study/rules/observer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hedgehog::study {

namespace {

double weibull_rate(double share) noexcept { return -std::log1p(-share); }

// Steepness of the logistic half relative to the Weibull half, in dF/dx at the threshold. The
// reference does not specify it; with this value all three experiments agree with it within the
// standard error (README).
constexpr double kLogisticSteepness = 0.8;

/// The logistic's slope on the linear axis.
double logistic_rate(const Observer& observer) noexcept {
  const double share = observer.at_threshold;
  const double steepness = kLogisticSteepness * observer.slope * weibull_rate(share) *
                           (1.0 - share) / observer.threshold;
  return steepness / (share * (1.0 - share));
}

double odds_of(double share) noexcept { return share / (1.0 - share); }

}  // namespace

double Observer::positive_at(double level) const noexcept {
  // At level 0 nothing is felt, and identical intervals are indistinguishable.
  double share = 0.0;
  if (level > 0.0 && curve == Curve::kWeibull) {
    share = -std::expm1(-weibull_rate(at_threshold) * std::pow(level / threshold, slope));
  } else if (level > 0.0) {
    const double distance = logistic_rate(*this) * (level - threshold);
    share = 1.0 / (1.0 + std::exp(-distance) / odds_of(at_threshold));
  }
  return guess + (1.0 - guess - lapse) * share;
}

double Observer::level_at(double probability) const noexcept {
  const double share = (probability - guess) / (1.0 - guess - lapse);
  if (share <= 0.0) return 0.0;
  if (share >= 1.0) return std::numeric_limits<double>::infinity();
  if (curve == Curve::kWeibull)
    return threshold * std::pow(weibull_rate(share) / weibull_rate(at_threshold), 1.0 / slope);
  return std::max(
      0.0, threshold + std::log(odds_of(share) / odds_of(at_threshold)) / logistic_rate(*this));
}

double share_at_threshold(Task task) noexcept { return task == Task::kYesNo ? 0.8 : 0.6; }

Population thesis_population(Quantity quantity) noexcept {
  switch (quantity) {
    case Quantity::kCurrentA:
      return {.median = 2.1, .log_sd = 0.25, .slope_low = 2.0, .slope_high = 5.0};
    case Quantity::kCurrentPercent:
      return {.median = 13.0, .log_sd = 0.35};
    case Quantity::kSpeedPercent:
      break;
  }
  return {.median = 45.0, .log_sd = 0.60};
}

Observer drawn_observer(const Experiment& experiment, const Population& population,
                        std::uint64_t seed, std::uint64_t number) noexcept {
  const auto uniform = [&](std::uint64_t which) {
    return draw(seed, Purpose::kPerson, {word_of(experiment.name), number, which});
  };
  const double radius = std::sqrt(-2.0 * std::log1p(-uniform(0)));
  const double normal = radius * std::cos(2.0 * std::numbers::pi * uniform(1));
  Observer observer;
  observer.threshold = population.median * std::exp(population.log_sd * normal);
  observer.slope =
      population.slope_low + (population.slope_high - population.slope_low) * uniform(2);
  observer.curve = number % 2 == 0 ? Curve::kWeibull : Curve::kLogistic;
  observer.guess = experiment.task == Task::kYesNo ? population.false_alarm : 0.5;
  observer.lapse = population.lapse;
  observer.at_threshold = share_at_threshold(experiment.task);
  return observer;
}

bool simulated_answer(const Observer& observer, double level, std::uint64_t seed,
                      std::uint64_t experiment, int scored_trial) noexcept {
  return draw(seed, Purpose::kAnswer, {experiment, static_cast<std::uint64_t>(scored_trial)}) <
         observer.positive_at(level);
}

double convergence_point(const StaircaseRule& rule) {
  // Where the drifts balance: P(down) * step down = P(up) * step up, with the probabilities that a
  // new pair of run counters ends by n consecutive positives or by m consecutive negatives.
  const Stage& last = rule.stages.back();
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 100; ++i) {
    const double p = 0.5 * (low + high);
    const double q = 1.0 - p;
    const double a = std::pow(p, rule.positives_down - 1);
    const double b = std::pow(q, rule.negatives_up - 1);
    const double down = a * (1.0 - std::pow(q, rule.negatives_up));
    const double up = b * (1.0 - std::pow(p, rule.positives_down));
    const bool falls =
        down * static_cast<double>(last.step_down) > up * static_cast<double>(last.step_up);
    (falls ? high : low) = p;
  }
  return 0.5 * (low + high);
}

}  // namespace hedgehog::study
