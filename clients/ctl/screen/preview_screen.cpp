// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/preview_screen.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "clients/ctl/terminal/bar.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {
namespace {

constexpr std::size_t kCurveColumns = 50;
/// Drawn as no current below this.
constexpr double kNothingA = 0.05;

/// Means of `steps` in one section per column.
std::vector<double> curve(const std::vector<std::array<double, 3>>& steps, std::size_t axis) {
  const std::size_t columns = std::min(kCurveColumns, steps.size());
  std::vector<double> means;
  means.reserve(columns);
  for (std::size_t i = 0; i < columns; ++i) {
    const std::size_t first = i * steps.size() / columns;
    const std::size_t last = (i + 1) * steps.size() / columns;
    double sum = 0.0;
    for (std::size_t k = first; k < last; ++k) sum += steps[k][axis];
    means.push_back(sum / static_cast<double>(last - first));
  }
  return means;
}

/// A variation of less than 2 % is drawn as a line.
bool is_constant(double lowest_a, double highest_a) {
  constexpr double kSmallPart = 0.02;
  const double largest_a = std::max(std::abs(lowest_a), std::abs(highest_a));
  return highest_a - lowest_a <= std::max(kNothingA, kSmallPart * largest_a);
}

std::string constant_line(std::size_t columns, bool ascii) {
  std::string line;
  for (std::size_t i = 0; i < columns; ++i) line += ascii ? "-" : "─";
  return line;
}

double span_of(const std::vector<double>& values) {
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  return values.empty() ? 0.0 : *highest - *lowest;
}

std::string percent(double ratio) { return fixed(100.0 * ratio, 0) + " %"; }

std::string limits_words(const protocol::PreviewResult& preview) {
  if (!preview.limited_by) return "nothing: full strength";
  if (*preview.limited_by != "thermal") return "the owner's gain";
  const double from_s = static_cast<double>(preview.limited_from_ms.value_or(0)) / 1000.0;
  return "heat, from " + fixed(from_s, 2) + " s on: " + percent(preview.delivered.mean) +
         " on average, at least " + percent(preview.delivered.min);
}

}  // namespace

std::vector<std::string> preview_screen(const std::string& what,
                                        const protocol::PreviewResult& preview, bool ascii) {
  std::array<std::vector<double>, 3> curves;
  double span_a = kNothingA;
  double max_duty = 0.0;
  for (std::size_t axis = 0; axis < curves.size(); ++axis) {
    curves[axis] = curve(preview.current_a, axis);
    span_a = std::max(span_a, span_of(curves[axis]));
    for (const auto& duty : preview.duty) max_duty = std::max(max_duty, std::abs(duty[axis]));
  }
  std::vector<std::string> lines{what + ", " + std::to_string(preview.duration_ms) +
                                 " ms, if it were started now. Nothing was played."};
  for (std::size_t axis = 0; axis < curves.size(); ++axis) {
    const auto [lowest, highest] =
        std::minmax_element(preview.current_a.begin(), preview.current_a.end(),
                            [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    std::string line = std::string("  ") + "xyz"[axis] + "  ";
    if (lowest == preview.current_a.end() ||
        std::max(std::abs((*lowest)[axis]), std::abs((*highest)[axis])) < kNothingA) {
      line += "nothing flows";
    } else if (is_constant((*lowest)[axis], (*highest)[axis])) {
      line += left(fixed(0.5 * ((*lowest)[axis] + (*highest)[axis]), 1) + " A", 18) +
              constant_line(curves[axis].size(), ascii);
    } else {
      line += left(fixed((*lowest)[axis], 1) + " to " + fixed((*highest)[axis], 1) + " A", 18) +
              sparkline(curves[axis], span_a, ascii);
    }
    lines.push_back(std::move(line));
  }
  lines.push_back("  current      " + fixed(preview.peak_current_a, 1) + " A at most, duty " +
                  percent(max_duty));
  lines.push_back("  temperature  " + fixed(preview.temperature_c, 1) + " °C now, " +
                  fixed(preview.peak_temperature_c, 1) + " °C at most");
  lines.push_back("  limited by   " + limits_words(preview));
  return lines;
}

}  // namespace hedgehog::client
