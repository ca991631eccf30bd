// SPDX-License-Identifier: MIT
// Thesis Table 2.1 (extension of the pins), computed, with the printed values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/design/study.h"

namespace hedgehog::design {

struct ExtensionRow {
  std::string array;
  std::size_t faces = 0;
  std::size_t size = 0;
  /// As in all verbs: rest of the pin without current, and extension from there.
  std::optional<double> rest_mm;
  std::optional<double> extension_mm;
  /// As in the thesis: from zero crossing to crossing, ignoring the shell.
  std::optional<double> crossings_mm;
  std::optional<double> thesis_mm;
  /// The printed value is reproduced within `kPrintedToleranceMm`.
  bool reproduced = false;
  /// Why it is not; empty if it is, or if none is printed.
  std::string reason;
};

/// Tolerance for a printed value, of one digit, to count as reproduced.
inline constexpr double kPrintedToleranceMm = 0.1;

std::vector<ExtensionRow> extension_rows(const Study& study);
/// cD, wD, tkD, otherwise as `design`.
Result<std::vector<ExtensionRow>> table_21(const Design& design);

class Table;
Table extension_table(const std::vector<ExtensionRow>& rows);

}  // namespace hedgehog::design
