// SPDX-License-Identifier: MIT
// The six panels of thesis Fig. 2.10, or those of one design.
#pragma once

#include <optional>
#include <vector>

#include "clients/design/output/picture.h"
#include "clients/design/study.h"

namespace hedgehog::design {

/// cD, wD and tkD with shields of 3 and of 4 mm, otherwise as `design`.
Result<std::vector<Study>> figure_210(const Design& design);

/// The force axis of thesis Fig. 2.10, N: its numbers are -2, 0, 2, 4 and 6, and the strongest
/// computed pull of its curves, that of tkD's pentagons, is 2.96 N.
inline constexpr Point kThesisForcesN{-3.0, 6.0};
inline constexpr double kThesisForceTickN = 2.0;

/// One panel per study, with the coil force and the thesis' values marked. `forces_n`: the force
/// axis of all panels; nullopt: the thesis' for several panels, from the data for one. Equal ends:
/// from each panel's data.
Picture curves_picture(const std::vector<Study>& studies, const model::OffsetGrid& grid,
                       std::optional<Point> forces_n = {});

}  // namespace hedgehog::design
