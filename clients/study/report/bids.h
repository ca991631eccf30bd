// SPDX-License-Identifier: MIT
// The data in the layout of the Brain Imaging Data Structure, behavioural part: one _beh.tsv per
// run with its JSON side-car.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/report/collect.h"

namespace hedgehog::study {

/// "sub-P01/beh/sub-P01_task-forcejnd_run-1_beh", without extension.
std::string bids_name(const AnalysedRun& run);

/// EX_CANTCREAT if the folder `out` exists: nothing is overwritten, and a failure leaves no files
/// behind. EX_DATAERR if two participants or experiments have the same BIDS label. `authors`: of
/// the data; empty: the experimenters' codes, and the program.
Result<void> write_bids(const std::filesystem::path& out, const StudyFolder& study,
                        const std::vector<AnalysedRun>& runs,
                        const std::vector<std::string>& authors = {});
/// The same rows in one CSV file.
Result<void> write_csv(const std::filesystem::path& file, const std::vector<AnalysedRun>& runs);

}  // namespace hedgehog::study
