// SPDX-License-Identifier: MIT
// The two figures of the thesis (3.4 and 3.5), drawn by gnuplot as SVG and PNG.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/report/collect.h"

namespace hedgehog::study {

/// The gnuplot commands for one staircase: levels, answers, reversals, threshold.
std::string staircase_plot(const AnalysedRun& run);
/// For the group figure: a panel an experiment, with people, mean, SD and the thesis' mean.
std::string group_plot(const std::vector<AnalysedGroup>& groups);

/// File name without folder and ending: "P01.force-jnd.1".
std::string figure_name(const AnalysedRun& run);

/// Draws into `folder`: NAME.svg and NAME.png a run, groups.svg, groups.png. EX_UNAVAILABLE when
/// there is no gnuplot or it fails.
Result<void> draw(const std::filesystem::path& folder, const std::vector<AnalysedRun>& runs,
                  const std::vector<AnalysedGroup>& groups);

}  // namespace hedgehog::study
