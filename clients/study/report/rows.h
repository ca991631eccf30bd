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

/// "n/a" for missing values. Device times are seconds with nine decimals. `excluded`: why the run
/// was excluded; nullopt: included.
std::vector<std::vector<std::string>> rows_of(const RecordedRun& run,
                                              const std::optional<std::string>& excluded = {});

/// Tabs and line feeds in cells are replaced by spaces.
std::string tsv_line(const std::vector<std::string>& cells);

}  // namespace hedgehog::study
