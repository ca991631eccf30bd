// SPDX-License-Identifier: MIT
// One frame of the tour, 80x22: the ball unrolled, what is being played, and what it costs.
#pragma once

#include <string>
#include <vector>

#include "clients/ctl/demo/tour.h"
#include "clients/ctl/screen/ball.h"
#include "clients/ctl/screen/status_screen.h"

namespace hedgehog::client {

/// `playing` is the last step that was shown, or nothing.
std::vector<std::string> demo_screen(const Ball& ball, const TourChapter& chapter,
                                     const TourStep* playing, const ScreenStyle& style);

}  // namespace hedgehog::client
