// SPDX-License-Identifier: MIT
// Thesis Table 2.1 (how far pins can move), computed, beside what is printed there.
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
  /// As all verbs have them: where the pin is without current, and how far it moves from there.
  std::optional<double> rest_mm;
  std::optional<double> extension_mm;
  /// As the thesis counts: from zero crossing to crossing, through the shell too.
  std::optional<double> crossings_mm;
  std::optional<double> thesis_mm;
  /// The printed value comes out, within `kPrintedToleranceMm`.
  bool reproduced = false;
  /// Why it does not; empty when it does, or nothing is printed.
  std::string reason;
};

/// Within which a printed value, of one digit, counts as reproduced.
inline constexpr double kPrintedToleranceMm = 0.1;

std::vector<ExtensionRow> extension_rows(const Study& study);
/// cD, wD, tkD, otherwise as `design`.
Result<std::vector<ExtensionRow>> table_21(const Design& design);

class Table;
Table extension_table(const std::vector<ExtensionRow>& rows);

}  // namespace hedgehog::design
