// SPDX-License-Identifier: MIT
// Parsing of sizes: magnets as DIAMETERxHEIGHT in mm ("8x10"), ranges as FIRST..LAST or
// FIRST..LAST/STEP ("3..5", "3..5/0.1").
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clients/common/problem.h"

namespace hedgehog::design {

/// A cylinder, mm.
struct Size {
  double diameter_mm = 0.0;
  double height_mm = 0.0;
  friend bool operator==(const Size&, const Size&) = default;
};

/// "8x10", both 0.1 to 100 mm. `what`: its name in the error ("--magnet").
Result<Size> parse_size(std::string_view text, const std::string& what);

/// "3", "3..5" (in steps of `step`) or "3..5/0.1": the numbers, ascending. At most 1000 of them,
/// each from `min` to `max`.
Result<std::vector<double>> parse_range(std::string_view text, double step, double min, double max,
                                        const std::string& what);

/// "3..5x10", "6..8/0.5x8..12/1": each diameter with each height.
Result<std::vector<Size>> parse_sizes(std::string_view text, double step, const std::string& what);

/// "8x10", the format of `parse_size`.
std::string to_text(const Size& size);

/// Shortest form: 4, 0.25, 12.5; at most four decimals.
std::string to_text(double number);

}  // namespace hedgehog::design
