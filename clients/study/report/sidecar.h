// SPDX-License-Identifier: MIT
// What stands beside a run's rows: everything about it that is not a row.
#pragma once

#include <string>

#include "clients/study/report/collect.h"

namespace hedgehog::study {

/// JSON: protocol with every choice, ball, calibration, check list, remarks, columns.
std::string bids_sidecar(const AnalysedRun& run);

}  // namespace hedgehog::study
