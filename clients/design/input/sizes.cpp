// SPDX-License-Identifier: MIT
#include "clients/design/input/sizes.h"

#include <array>
#include <cmath>
#include <optional>

#include "base/keys/value.h"
#include "base/number_text.h"
#include "clients/design/input/number.h"

namespace hedgehog::design {
namespace {

constexpr double kMinMm = 0.1;
constexpr double kMaxMm = 100.0;
constexpr double kMaxSteps = 1000;

std::optional<double> finite_number(std::string_view text) {
  const auto number = parse_number<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

Problem error_message(const std::string& what, const std::string& reason) {
  return {kUsage, what + ": " + reason};
}

std::string quoted(std::string_view text) { return "'" + keys::printable(text) + "'"; }

/// Splits at the 'x' between diameter and height.
std::optional<std::array<std::string_view, 2>> halves(std::string_view text) {
  const std::size_t x = text.find('x');
  if (x == std::string_view::npos || text.find('x', x + 1) != std::string_view::npos) return {};
  return std::array{text.substr(0, x), text.substr(x + 1)};
}

}  // namespace

Result<std::vector<double>> parse_range(std::string_view text, double step, double min, double max,
                                        const std::string& what) {
  const std::string shape = " is neither a number nor a range such as 3..5 or 3..5/0.1";
  const std::size_t dots = text.find("..");
  const std::size_t slash = text.find('/');
  const bool range = dots != std::string_view::npos;
  const auto first = finite_number(text.substr(0, range ? dots : text.size()));
  std::optional<double> last = first;
  if (range) {
    const std::size_t from = dots + 2;
    last = finite_number(text.substr(from, slash == std::string_view::npos ? slash : slash - from));
    if (slash != std::string_view::npos) {
      const auto typed = finite_number(text.substr(slash + 1));
      if (!typed || *typed <= 0.0) return error_message(what, quoted(text) + shape);
      step = *typed;
    }
  }
  if (!first || !last) return error_message(what, quoted(text) + shape);
  for (const double value : {*first, *last}) {
    if (value < min || value > max) {
      return error_message(what,
                           to_text(value) + " is outside " + to_text(min) + " to " + to_text(max));
    }
  }
  if (*last < *first) return error_message(what, quoted(text) + " ends below where it begins");
  const double count = std::floor((*last - *first) / step + 1e-6) + 1.0;
  if (count > kMaxSteps) return error_message(what, quoted(text) + " has more than 1000 steps");
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < static_cast<int>(count); ++i) values.push_back(*first + i * step);
  return values;
}

Result<Size> parse_size(std::string_view text, const std::string& what) {
  const auto parts = halves(text);
  const auto diameter = parts ? finite_number((*parts)[0]) : std::nullopt;
  const auto height = parts ? finite_number((*parts)[1]) : std::nullopt;
  if (!diameter || !height)
    return error_message(what,
                         quoted(text) + " is not a magnet: DIAMETERxHEIGHT in mm, such as 8x10");
  for (const double mm : {*diameter, *height}) {
    if (mm < kMinMm || mm > kMaxMm) {
      return error_message(what,
                           quoted(text) + ": " + to_text(mm) +
                               " mm is outside 0.1 to 100 mm; magnets are DIAMETERxHEIGHT in mm");
    }
  }
  return Size{*diameter, *height};
}

Result<std::vector<Size>> parse_sizes(std::string_view text, double step, const std::string& what) {
  const auto parts = halves(text);
  if (!parts) {
    return error_message(
        what, quoted(text) + " is no range of magnets: DIAMETERxHEIGHT, such as 3..5x10");
  }
  const auto diameters = parse_range((*parts)[0], step, kMinMm, kMaxMm, what);
  if (!diameters) return diameters.error();
  const auto heights = parse_range((*parts)[1], 1.0, kMinMm, kMaxMm, what);
  if (!heights) return heights.error();
  std::vector<Size> sizes;
  for (const double diameter : *diameters)
    for (const double height : *heights) sizes.push_back({diameter, height});
  return sizes;
}

std::string to_text(double number) {
  std::string text = base::fixed(number, 4);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string to_text(const Size& size) {
  return to_text(size.diameter_mm) + "x" + to_text(size.height_mm);
}

}  // namespace hedgehog::design
