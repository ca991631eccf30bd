// SPDX-License-Identifier: MIT
// Metadata of a run that accompanies its rows.
#pragma once

#include <string>

#include "clients/study/report/collect.h"

namespace hedgehog::study {

/// JSON: protocol with every design choice, ball, calibration, check list, remarks, columns.
std::string bids_sidecar(const AnalysedRun& run);

}  // namespace hedgehog::study
