// SPDX-License-Identifier: MIT
#include "clients/study/rules/distinguishable_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.h"

namespace hedgehog::study {

namespace {

// sqrt(2) * the 80 % point of the normal distribution.
constexpr double kPrimeOfJnd = 1.1902;
constexpr double kTwoPrime = 2.0;
// A ratio that is an integer number of steps must not lose one to rounding.
constexpr double kStepSlack = 1e-9;
constexpr double kMaxSteps = 1e9;

// Thesis, section 3.2.4.
constexpr double kAboutForce = 10.0;
constexpr double kAboutSpeed = 20.0;
constexpr double kAbout = 0.5;

/// How a count matches the thesis' statement; empty if it does not.
std::string as_stated(double steps, double stated) {
  if (std::abs(steps - stated) < kAbout)
    return fmt::format("the steps: the thesis' \"about {:.0f}\"", stated);
  if (std::abs(1.0 + steps - stated) < kAbout)
    return fmt::format("1 + steps = {:.2f}: the thesis' \"about {:.0f}\"", 1.0 + steps, stated);
  return {};
}

std::string range_text(double low, double high, const char* unit) {
  return fmt::format("{:.3g} to {:.3g} {}", low, high, unit);
}

}  // namespace

LevelCount count_levels(double low, double high, double fraction, Spacing spacing, double reference,
                        double apart) {
  LevelCount count;
  if (!(low > 0.0 && low < high && fraction > 0.0)) return count;
  switch (spacing) {
    case Spacing::kWeber:
      count.steps = std::log(high / low) / (apart * std::log1p(fraction));
      break;
    case Spacing::kConstant:
      count.steps = (high - low) / (apart * fraction * reference);
      break;
    case Spacing::kWeberTwoPrime:
      count.steps = std::log(high / low) / (apart * std::log1p(fraction)) * kPrimeOfJnd / kTwoPrime;
      break;
  }
  count.levels = static_cast<int>(std::min(std::floor(count.steps + kStepSlack), kMaxSteps)) + 1;
  return count;
}

std::vector<LevelFormula> level_formulas(double threshold_a, double force_fraction,
                                         double speed_fraction, double max_a, double continuous_a,
                                         double reference_pins_s) {
  const double a = continuous_a;
  const double s = reference_pins_s;
  const std::string whole = range_text(threshold_a, max_a, "A");
  const std::string upper = range_text(continuous_a, max_a, "A");
  const std::string lasting = range_text(threshold_a, continuous_a, "A");
  const char* weber = "Weber: ln(hi/lo) / ln(1+w)";
  const char* constant = "constant: (hi-lo) / (w ref)";
  const LevelCount to_spikes =
      count_levels(continuous_a, max_a, force_fraction, Spacing::kWeber, a);
  const LevelCount two_apart =
      count_levels(threshold_a, max_a, force_fraction, Spacing::kConstant, a, 2.0);
  const LevelCount two_prime =
      count_levels(threshold_a, max_a, force_fraction, Spacing::kWeberTwoPrime, a);
  const LevelCount to_100 = count_levels(1, 100, speed_fraction, Spacing::kConstant, s);
  return {
      {whole, weber, count_levels(threshold_a, max_a, force_fraction, Spacing::kWeber, a),
       "the default"},
      {lasting, weber, count_levels(threshold_a, continuous_a, force_fraction, Spacing::kWeber, a),
       "without overheating"},
      {upper, weber, to_spikes, as_stated(to_spikes.steps, kAboutForce)},
      {whole, "constant, two JND apart: (hi-lo) / (2 w ref)", two_apart,
       as_stated(two_apart.steps, kAboutForce)},
      {whole, "Weber, d' = 2 apart", two_prime, ""},
      {whole, constant, count_levels(threshold_a, max_a, force_fraction, Spacing::kConstant, a),
       ""},
      {range_text(1, 50, "pins/s"), weber, count_levels(1, 50, speed_fraction, Spacing::kWeber, s),
       ""},
      {range_text(1, 100, "pins/s"), constant, to_100, as_stated(to_100.steps, kAboutSpeed)},
      {range_text(1, 50, "pins/s"), constant,
       count_levels(1, 50, speed_fraction, Spacing::kConstant, s), ""},
  };
}

std::vector<std::string> level_remarks(double threshold_a, double force_fraction,
                                       double speed_fraction, double max_a, double continuous_a,
                                       double reference_pins_s) {
  const double ratio = std::pow(1.0 + speed_fraction, kAboutSpeed);
  const double span = kAboutSpeed * speed_fraction * reference_pins_s;
  const LevelCount force =
      count_levels(threshold_a, max_a, force_fraction, Spacing::kConstant, continuous_a);
  const LevelCount speed =
      count_levels(1, 50, speed_fraction, Spacing::kConstant, reference_pins_s);
  std::vector<std::string> remarks{
      fmt::format("20 steps of speed: Weber steps of {:.3g} % would need a range of {} to 1,",
                  100.0 * speed_fraction, base::grouped(ratio, ',')),
      fmt::format("constant ones of {:.3g} pins/s a span of {:.3g} pins/s.",
                  speed_fraction * reference_pins_s, span)};
  if (std::abs(force.steps - kAboutSpeed) < kAbout &&
      std::abs(speed.steps - kAboutForce) < kAbout) {
    remarks.push_back(fmt::format(
        "Constant steps give {:.1f} for force and, over 1 to 50 pins/s, {:.1f} for speed:",
        force.steps, speed.steps));
    remarks.emplace_back("the thesis' two numbers may be swapped in its text; a hypothesis only.");
  }
  return remarks;
}

}  // namespace hedgehog::study
