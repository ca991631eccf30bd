// SPDX-License-Identifier: MIT
#include "clients/ctl/terminal/bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace hedgehog::client {

namespace {

/// The column of `value`, 0..kBarColumns.
int column_of(double value, double low, double high) {
  const double position = (value - low) / (high - low) * kBarColumns;
  return std::isfinite(position)
             ? static_cast<int>(std::lround(std::clamp(position, 0.0, double{kBarColumns})))
             : 0;
}

}  // namespace

std::string bar(double value, double low, double high, std::span<const double> marks, bool ascii) {
  const int filled = column_of(value, low, high);
  std::string line;
  for (int column = 0; column < kBarColumns; ++column) {
    const bool full = column < filled;
    const bool marked = std::any_of(marks.begin(), marks.end(), [&](double mark) {
      return column_of(mark, low, high) == column + 1;
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
