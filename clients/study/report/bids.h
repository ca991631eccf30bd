// SPDX-License-Identifier: MIT
// The data in the layout of the Brain Imaging Data Structure, behavioural part: one _beh.tsv a run
// with its JSON side-car.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/report/collect.h"

namespace hedgehog::study {

/// "sub-P01/beh/sub-P01_task-forcejnd_run-1_beh", without ending.
std::string bids_name(const AnalysedRun& run);
/// Protocol with every choice, ball, calibration, check list, columns.
std::string bids_sidecar(const AnalysedRun& run);

/// EX_CANTCREAT when `folder` is there already: nothing is overwritten, and what fails leaves
/// nothing behind. EX_DATAERR when two people or experiments are one to BIDS.
Result<void> write_bids(const std::filesystem::path& folder, const StudyFolder& study,
                        const std::vector<AnalysedRun>& runs);
/// The same rows in one CSV file.
Result<void> write_csv(const std::filesystem::path& file, const std::vector<AnalysedRun>& runs);

}  // namespace hedgehog::study
