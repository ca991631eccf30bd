// SPDX-License-Identifier: MIT
// The data as one flat table: a row for each presentation block, void and practice ones included.
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

/// "n/a" for what there is not. Device times are seconds with nine decimals. `excluded`: why the
/// run was left out, if it was.
std::vector<std::vector<std::string>> rows_of(const RecordedRun& run,
                                              const std::optional<std::string>& excluded = {});

/// Tabs and line feeds in cells become blanks.
std::string tsv_line(const std::vector<std::string>& cells);

}  // namespace hedgehog::study
