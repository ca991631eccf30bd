// SPDX-License-Identifier: MIT
// The whole analysis as one self-contained page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "clients/study/report/collect.h"

namespace hedgehog::study {

/// `figures`: the output folder of `draw`; missing figures are left out.
std::string report_page(const StudyFolder& study, const std::vector<AnalysedRun>& runs,
                        const std::vector<AnalysedGroup>& groups,
                        const std::filesystem::path& figures);

}  // namespace hedgehog::study
