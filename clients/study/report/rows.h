// SPDX-License-Identifier: MIT
// The data as one flat table: a row per presentation block, including void and practice ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/study/journal/recorded_run.h"

namespace hedgehog::study {

struct Column {
  const char* name;
  const char* description;
};
/// In the order of the cells.
const std::vector<Column>& columns();

/// How the report uses a run.
struct RunUse {
  /// Why the experimenter excluded it; nullopt: not excluded.
  std::optional<std::string> excluded{};
  /// `AnalysedRun::in_group`.
  bool in_mean = false;
};

/// "n/a" for missing values. Device times are seconds with nine decimals.
std::vector<std::vector<std::string>> rows_of(const RecordedRun& run, const RunUse& use);

/// Tabs and line feeds in cells are replaced by spaces.
std::string tsv_line(const std::vector<std::string>& cells);

}  // namespace hedgehog::study
