// SPDX-License-Identifier: MIT
#include "clients/study/rules/fit/weibull_fit.h"

#include <nlopt.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <memory>
#include <vector>

namespace hedgehog::study {

namespace {

using Pair = std::array<double, 2>;  // logarithms of threshold and slope

struct Box {
  Pair low{};
  Pair high{};
};

struct Point {
  Pair at{};
  double value = -INFINITY;
};

// The likelihood changes with the threshold in proportion to the slope: the rows of the grid are
// finer for steep curves.
constexpr int kGridSlopes = 12;
constexpr double kGridStep = 0.4;  // of the logarithm of the threshold, times the slope
constexpr std::size_t kStarts = 8;
constexpr double kTolerance = 1e-9;  // of both logarithms
constexpr int kMaxEvaluations = 500;
constexpr double kAtBound = 1e-6;

Box box_of(const Experiment& experiment) {
  const double ceiling = to_value(experiment.rule.ceiling, experiment.decimals());
  return {{std::log(ceiling / 1000.0), std::log(kMinSlope)},
          {std::log(ceiling), std::log(kMaxSlope)}};
}

/// The highest local maxima of a grid within its rows, one row per slope.
std::vector<Point> starts_in(const WeibullLikelihood& likelihood, const Box& box) {
  std::vector<Point> peaks;
  for (int row = 0; row <= kGridSlopes; ++row) {
    // Exactly within the box, as the optimiser requires.
    const double log_slope =
        std::lerp(box.low[1], box.high[1], static_cast<double>(row) / kGridSlopes);
    const int cells =
        static_cast<int>(std::ceil((box.high[0] - box.low[0]) * std::exp(log_slope) / kGridStep));
    std::vector<Point> points;
    for (int cell = 0; cell <= cells; ++cell) {
      const Pair at{std::lerp(box.low[0], box.high[0], static_cast<double>(cell) / cells),
                    log_slope};
      points.push_back({at, likelihood(at[0], at[1])});
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool above_left = i == 0 || points[i].value >= points[i - 1].value;
      const bool above_right = i + 1 == points.size() || points[i].value > points[i + 1].value;
      if (above_left && above_right) peaks.push_back(points[i]);
    }
  }
  std::sort(peaks.begin(), peaks.end(),
            [](const Point& a, const Point& b) { return a.value > b.value; });
  peaks.resize(std::min(peaks.size(), kStarts));
  return peaks;
}

struct Goal {
  const WeibullLikelihood& likelihood;
};
double height(unsigned, const double* at, double*, void* goal) {
  return static_cast<const Goal*>(goal)->likelihood(at[0], at[1]);
}

/// Maximizes from `start` with one of NLopt's algorithms.
Point climbed(nlopt_algorithm algorithm, const WeibullLikelihood& likelihood, const Box& box,
              const Point& start) {
  struct Destroy {
    void operator()(nlopt_opt optimiser) const { nlopt_destroy(optimiser); }
  };
  const std::unique_ptr<nlopt_opt_s, Destroy> optimiser(nlopt_create(algorithm, 2));
  const double slope = std::exp(start.at[1]);
  const Pair cell{kGridStep / slope, (box.high[1] - box.low[1]) / kGridSlopes};
  Goal goal{likelihood};
  nlopt_set_max_objective(optimiser.get(), height, &goal);
  nlopt_set_lower_bounds(optimiser.get(), box.low.data());
  nlopt_set_upper_bounds(optimiser.get(), box.high.data());
  nlopt_set_initial_step(optimiser.get(), cell.data());
  nlopt_set_xtol_abs1(optimiser.get(), kTolerance);
  nlopt_set_maxeval(optimiser.get(), kMaxEvaluations);
  Point point = start;
  // Also valid if the optimiser stops because of rounding.
  nlopt_optimize(optimiser.get(), point.at.data(), &point.value);
  return point.value >= start.value ? point : start;
}

/// The global maximum. From each start by Powell's BOBYQA (2009), which is fast but sometimes stops
/// on a ridge; from the best of them by Rowan's Subplex (1990), which does not.
Point highest(const WeibullLikelihood& likelihood, const Box& box) {
  Point best;
  for (const Point& start : starts_in(likelihood, box)) {
    const Point top = climbed(NLOPT_LN_BOBYQA, likelihood, box, start);
    if (top.value > best.value) best = top;
  }
  return climbed(NLOPT_LN_SBPLX, likelihood, box, best);
}

bool at_bound(const Box& box, const Point& point, std::size_t which) {
  return point.at[which] - box.low[which] < kAtBound ||
         box.high[which] - point.at[which] < kAtBound;
}

/// The maximum likelihood of curves with this location, over the slope.
double profile(const WeibullLikelihood& likelihood, double log_location) {
  constexpr int kCells = 8;
  constexpr int kBits = 20;
  const double low = std::log(kMinSlope);
  const double width = (std::log(kMaxSlope) - low) / kCells;
  const auto cost = [&](double log_slope) { return -likelihood(log_location, log_slope); };
  int best = 0;
  double lowest = cost(low);
  for (int cell = 1; cell <= kCells; ++cell) {
    const double value = cost(low + width * cell);
    if (value < lowest) {
      lowest = value;
      best = cell;
    }
  }
  const auto [slope, value] = boost::math::tools::brent_find_minima(
      cost, low + width * std::max(0, best - 1), low + width * std::min(kCells, best + 1), kBits);
  return -std::min(value, lowest);
}

/// The location between `from` and `to` where the profile falls below `wanted`; `to` if it does
/// not.
double crossing(const WeibullLikelihood& likelihood, double from, double to, double wanted) {
  constexpr double kStep = 0.05;
  constexpr int kBits = 20;
  const auto above = [&](double at) { return profile(likelihood, at) - wanted; };
  const double step = to > from ? kStep : -kStep;
  double inside = from;
  double inside_value = above(inside);
  if (inside_value <= 0.0) return inside;
  while (inside != to) {
    const double next = std::abs(to - inside) < kStep ? to : inside + step;
    const double next_value = above(next);
    if (next_value < 0.0) {
      std::uintmax_t iterations = 50;
      const auto [a, b] = boost::math::tools::toms748_solve(
          above, std::min(inside, next), std::max(inside, next),
          inside < next ? inside_value : next_value, inside < next ? next_value : inside_value,
          boost::math::tools::eps_tolerance<double>(kBits), iterations);
      return 0.5 * (a + b);
    }
    inside = next;
    inside_value = next_value;
  }
  return to;
}

/// The likelihood ratio (twice the drop of the log likelihood) at the ends of an interval. Chi
/// square's 3.84 assumes many independent trials; for the few trials of a staircase, and with a
/// curve of another family for half of the people, such an interval contains the true threshold in
/// 85 to 90 %. These are the 95 % quantiles of the ratio at the true threshold of 2,000 simulated
/// people per experiment (seed 401: 5.1; 5.5 and 6.0), verified with other seeds (README).
double critical_ratio(Task task) { return task == Task::kYesNo ? 5.1 : 5.7; }

}  // namespace

WeibullFit fit_weibull(const Experiment& experiment, std::span<const Judgement> judgements,
                       double guess, double lapse) {
  const double share = share_at_threshold(experiment.task);
  const WeibullLikelihood likelihood(judgements, guess, lapse, share);
  const Box box = box_of(experiment);
  const Point best = highest(likelihood, box);
  WeibullFit fit;
  fit.observer = {Curve::kWeibull, std::exp(best.at[0]), std::exp(best.at[1]), guess, lapse, share};
  fit.threshold = fit.observer.level_at(convergence_point(experiment.rule));
  fit.log_likelihood = best.value;
  fit.threshold_at_bound = at_bound(box, best, 0);
  fit.slope_at_bound = at_bound(box, best, 1);
  return fit;
}

std::optional<Interval> profile_interval(const Experiment& experiment,
                                         std::span<const Judgement> judgements,
                                         const WeibullFit& fit) {
  const double guess = fit.observer.guess;
  const double lapse = fit.observer.lapse;
  const double share = (convergence_point(experiment.rule) - guess) / (1.0 - guess - lapse);
  if (share <= 0.0 || share >= 1.0) return std::nullopt;
  const WeibullLikelihood likelihood(judgements, guess, lapse, share);
  const Box box = box_of(experiment);
  const double top = std::clamp(std::log(fit.threshold), box.low[0], box.high[0]);
  const double wanted = std::max(fit.log_likelihood, profile(likelihood, top)) -
                        0.5 * critical_ratio(experiment.task);
  const double low = crossing(likelihood, top, box.low[0], wanted);
  const double high = crossing(likelihood, top, box.high[0], wanted);
  return Interval{std::exp(low), std::exp(high), low == box.low[0], high == box.high[0]};
}

}  // namespace hedgehog::study
