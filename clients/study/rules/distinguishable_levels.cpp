// SPDX-License-Identifier: MIT
#include "clients/study/rules/distinguishable_levels.h"

#include <cmath>
#include <cstdio>

namespace hedgehog::study {

namespace {

// sqrt(2) * the 80 % point of the normal distribution.
constexpr double kPrimeOfJnd = 1.1902;
constexpr double kTwoPrime = 2.0;
// A ratio that is a whole number of steps shall not lose one to rounding.
constexpr double kSlack = 1e-9;

std::string range_text(double low, double high, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3g to %.3g %s", low, high, unit);
  return text;
}

}  // namespace

LevelCount count_levels(double low, double high, double fraction, Spacing spacing, double reference,
                        double apart) {
  LevelCount count;
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
  count.levels = static_cast<int>(std::floor(count.steps + kSlack)) + 1;
  return count;
}

std::vector<LevelFormula> level_formulas(double threshold_a, double force_fraction,
                                         double speed_fraction, double most_a, double continuous_a,
                                         double reference_pins_s) {
  const double a = continuous_a;
  const double s = reference_pins_s;
  const std::string whole = range_text(threshold_a, most_a, "A");
  const std::string upper = range_text(continuous_a, most_a, "A");
  const std::string lasting = range_text(threshold_a, continuous_a, "A");
  const char* weber = "Weber: ln(hi/lo) / ln(1+w)";
  return {
      {whole, weber, count_levels(threshold_a, most_a, force_fraction, Spacing::kWeber, a),
       "the default"},
      {lasting, weber, count_levels(threshold_a, continuous_a, force_fraction, Spacing::kWeber, a),
       "without overheating"},
      {upper, weber, count_levels(continuous_a, most_a, force_fraction, Spacing::kWeber, a),
       "gives the thesis' \"about 10\""},
      {whole, "constant, two JND apart: (hi-lo) / (2 w ref)",
       count_levels(threshold_a, most_a, force_fraction, Spacing::kConstant, a, 2.0),
       "gives the thesis' \"about 10\""},
      {whole, "Weber, d' = 2 apart",
       count_levels(threshold_a, most_a, force_fraction, Spacing::kWeberTwoPrime, a), ""},
      {whole, "constant: (hi-lo) / (w ref)",
       count_levels(threshold_a, most_a, force_fraction, Spacing::kConstant, a), ""},
      {range_text(1, 50, "pins/s"), weber, count_levels(1, 50, speed_fraction, Spacing::kWeber, s),
       ""},
      {range_text(1, 100, "pins/s"), "constant: (hi-lo) / (w ref)",
       count_levels(1, 100, speed_fraction, Spacing::kConstant, s),
       "gives the thesis' \"about 20\""},
      {range_text(1, 50, "pins/s"), "constant: (hi-lo) / (w ref)",
       count_levels(1, 50, speed_fraction, Spacing::kConstant, s), ""},
  };
}

}  // namespace hedgehog::study
