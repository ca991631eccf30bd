// SPDX-License-Identifier: MIT
// Stimulus levels as integers, without rounding drift, so that a resumed run compares exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace hedgehog::study {

/// An integer multiple of 10^-decimals of the experiment's unit: of 0.0001 A, or of 0.001
/// percentage points of the reference.
using Level = std::int64_t;

/// 44512 with 4 decimals: "4.4512". Exact, without trailing zeros.
std::string exact_decimal(Level level, int decimals);

/// The arithmetic mean as a decimal rounded to 12 places (half to even), without trailing zeros.
/// REQUIRES: levels not empty, decimals <= 12, |mean| below 10^6 units.
std::string mean_decimal(std::span<const Level> levels, int decimals);

/// The mean as a number in the experiment's unit.
double mean_value(std::span<const Level> levels, int decimals);

double to_value(Level level, int decimals) noexcept;

/// `value` in units of 10^-decimals; nullopt if it has more decimals than that.
std::optional<Level> from_value(double value, int decimals) noexcept;

}  // namespace hedgehog::study
