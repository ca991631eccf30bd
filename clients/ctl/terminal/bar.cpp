// SPDX-License-Identifier: MIT
#include "clients/ctl/terminal/bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace hedgehog::client {

namespace {

/// The column of `value`, 0..width.
int column_of(double value, double low, double high, int width) {
  const double position = (value - low) / (high - low) * width;
  return std::isfinite(position)
             ? static_cast<int>(std::lround(std::clamp(position, 0.0, static_cast<double>(width))))
             : 0;
}

}  // namespace

std::string bar(double value, double low, double high, std::span<const double> marks, bool ascii,
                int width) {
  const int filled = column_of(value, low, high, width);
  std::string line;
  for (int column = 0; column < width; ++column) {
    const bool full = column < filled;
    const bool marked = std::any_of(marks.begin(), marks.end(), [&](double mark) {
      return column_of(mark, low, high, width) == column + 1;
    });
    if (ascii)
      line += marked ? '|' : full ? '=' : '-';
    else
      line += marked ? (full ? "╋" : "┊") : full ? "━" : "─";
  }
  return line;
}

std::string sparkline(std::span<const double> values, double min_span, bool ascii) {
  static constexpr std::array<std::string_view, 8> kBlocks{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  static constexpr std::array<std::string_view, 8> kAscii{"_", "_", ".", ".", "-", "-", "=", "="};
  if (values.empty()) return {};
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double span = std::max(*highest - *lowest, min_span);
  std::string line;
  for (const double value : values) {
    const double step = (value - *lowest) / span * 7.0;
    line += (ascii ? kAscii : kBlocks)[static_cast<std::size_t>(std::clamp(step, 0.0, 7.0))];
  }
  return line;
}

}  // namespace hedgehog::client
