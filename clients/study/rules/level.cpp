// SPDX-License-Identifier: MIT
#include "clients/study/rules/level.h"

#include <cmath>
#include <numeric>

namespace hedgehog::study {

namespace {

constexpr int kMeanPlaces = 12;

Level power_of_ten(int exponent) noexcept {
  Level power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

}  // namespace

std::string exact_decimal(Level level, int decimals) {
  const Level scale = power_of_ten(decimals);
  const Level magnitude = level < 0 ? -level : level;
  std::string text = (level < 0 ? "-" : "") + std::to_string(magnitude / scale);
  std::string fraction = std::to_string(magnitude % scale);
  fraction.insert(0,
                  static_cast<std::size_t>(decimals) -
                      std::min(fraction.size(), static_cast<std::size_t>(decimals)),
                  '0');
  while (!fraction.empty() && fraction.back() == '0') fraction.pop_back();
  return fraction.empty() ? text : text + "." + fraction;
}

std::string mean_decimal(std::span<const Level> levels, int decimals) {
  const Level sum = std::accumulate(levels.begin(), levels.end(), Level{0});
  const Level count = static_cast<Level>(levels.size());
  const bool negative = sum < 0;
  Level rest = negative ? -sum : sum;
  // Long division, one place at a time, so that nothing overflows.
  Level quotient = rest / count;
  rest %= count;
  for (int place = decimals; place < kMeanPlaces; ++place) {
    rest *= 10;
    quotient = quotient * 10 + rest / count;
    rest %= count;
  }
  if (2 * rest > count || (2 * rest == count && quotient % 2 == 1)) ++quotient;
  return exact_decimal(negative ? -quotient : quotient, kMeanPlaces);
}

double mean_value(std::span<const Level> levels, int decimals) {
  const Level sum = std::accumulate(levels.begin(), levels.end(), Level{0});
  return to_value(sum, decimals) / static_cast<double>(levels.size());
}

double to_value(Level level, int decimals) noexcept {
  return static_cast<double>(level) / static_cast<double>(power_of_ten(decimals));
}

std::optional<Level> from_value(double value, int decimals) noexcept {
  constexpr double kFarthest = 1e12;
  constexpr double kSlack = 1e-6;
  const double scaled = value * static_cast<double>(power_of_ten(decimals));
  if (!(std::abs(scaled) < kFarthest) || std::abs(scaled - std::round(scaled)) > kSlack)
    return std::nullopt;
  return static_cast<Level>(std::llround(scaled));
}

}  // namespace hedgehog::study
