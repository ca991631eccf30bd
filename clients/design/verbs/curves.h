// SPDX-License-Identifier: MIT
// The six panels of thesis Fig. 2.10, or those of one design.
#pragma once

#include "clients/design/output/picture.h"
#include "clients/design/study.h"

namespace hedgehog::design {

/// cD, wD and tkD with shields of 3 and of 4 mm, otherwise as `design`.
Result<std::vector<Study>> figure_210(const Design& design);

/// A panel each, with the coil's force and the thesis' values marked.
Picture curves_picture(const std::vector<Study>& studies, const model::OffsetGrid& grid);

}  // namespace hedgehog::design
