// SPDX-License-Identifier: MIT
// The two figures of the thesis (3.4 and 3.5), drawn by gnuplot as SVG and PNG.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/report/collect.h"

namespace hedgehog::study {

/// The gnuplot commands for one staircase: levels, responses, reversals, threshold.
std::string staircase_plot(const AnalysedRun& run);
/// For the group figure: a panel per experiment, with individual values, mean, SD and the thesis'
/// mean.
std::string group_plot(const std::vector<AnalysedGroup>& groups);

/// File name without folder and extension: "P01.force-jnd.1".
std::string figure_name(const AnalysedRun& run);

/// Draws into `folder`: NAME.svg and NAME.png per run, groups.svg, groups.png. EX_UNAVAILABLE if
/// gnuplot is not installed or fails.
Result<void> draw(const std::filesystem::path& folder, const std::vector<AnalysedRun>& runs,
                  const std::vector<AnalysedGroup>& groups);

}  // namespace hedgehog::study
