// SPDX-License-Identifier: MIT
// Simulated people: psychometric curves, and populations to draw them from.
#pragma once

#include <cstdint>
#include <string_view>

#include "clients/study/rules/draw.h"
#include "clients/study/rules/experiment.h"

namespace hedgehog::study {

/// A Weibull of the level, or a logistic on its linear axis.
enum class Curve : std::uint8_t { kWeibull, kLogistic };

/// psi(x) = guess + (1 - guess - lapse) * F(x); F(threshold) is the share at which an observer
/// without lapses and false alarms is positive in 80 % (F = 0.8 for yes/no, 0.6 for two intervals).
struct Observer {
  Curve curve = Curve::kWeibull;
  double threshold = 1.0;  // in the experiment's unit, above 0
  double slope = 3.0;      // Weibull's beta; a logistic has 0.8 of its steepness at the threshold
  /// Probability of a positive response without stimulus: 0.5 for two intervals, false alarms for
  /// yes/no.
  double guess = 0.5;
  double lapse = 0.02;
  /// F(threshold).
  double at_threshold = 0.6;

  /// Probability of a positive answer at a level >= 0.
  double positive_at(double level) const noexcept;
  /// The level at that probability; infinity or 0 if it is never or always reached.
  double level_at(double probability) const noexcept;
};

/// F(threshold) of a task.
double share_at_threshold(Task task) noexcept;

/// Distribution of observers: thresholds lognormal, slopes uniform, half of them Weibull and half
/// logistic.
struct Population {
  double median = 1.0;
  double log_sd = 0.3;
  double slope_low = 1.2;
  double slope_high = 3.0;
  double lapse = 0.02;
  double false_alarm = 0.02;  // yes/no only
};

/// Around the group means of the thesis: 2.1 A, 13 %, 45 %. A choice, not fitted to its data.
Population thesis_population(Quantity quantity) noexcept;

Observer drawn_observer(const Experiment& experiment, const Population& population,
                        std::uint64_t seed, std::uint64_t number) noexcept;

/// Whether the observer is correct (or answers yes) at the level in that scored trial. Independent
/// of repetitions of the trial.
bool simulated_answer(const Observer& observer, double level, std::uint64_t seed,
                      std::uint64_t experiment, int scored_trial) noexcept;

/// The probability to which a staircase of this rule with small steps converges: from the last
/// stage's steps and its run lengths (80.35 % for two-down/one-up with 0.5488).
double convergence_point(const StaircaseRule& rule);

}  // namespace hedgehog::study
