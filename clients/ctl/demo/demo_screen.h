// SPDX-License-Identifier: MIT
// One frame of the tour, 80x22: the unrolled ball, the current step, temperatures and current.
#pragma once

#include <string>
#include <vector>

#include "clients/ctl/demo/tour.h"
#include "clients/ctl/screen/ball.h"
#include "clients/ctl/screen/status_screen.h"

namespace hedgehog::client {

/// `playing`: the last step that was shown, or nullptr.
std::vector<std::string> demo_screen(const Ball& ball, const TourChapter& chapter,
                                     const TourStep* playing, const ScreenStyle& style);

}  // namespace hedgehog::client
