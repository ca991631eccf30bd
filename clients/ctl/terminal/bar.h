// SPDX-License-Identifier: MIT
// A horizontal gauge for a terminal.
#pragma once

#include <span>
#include <string>

namespace hedgehog::client {

/// Width of a gauge on a screen of 80 columns.
inline constexpr int kBarColumns = 26;

/// `value` on the scale `low`..`high` as a thick line, the rest thin; `marks` are drawn across it.
/// With `ascii`: = - |. `width`: in columns.
std::string bar(double value, double low, double high, std::span<const double> marks, bool ascii,
                int width = kBarColumns);

/// The last `values` as blocks of eight heights, scaled to their range (at least `min_span`).
std::string sparkline(std::span<const double> values, double min_span, bool ascii);

}  // namespace hedgehog::client
