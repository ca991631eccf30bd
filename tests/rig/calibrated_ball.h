// SPDX-License-Identifier: MIT
// A ball with the device file that `hedgehogctl calibrate --thermal` writes for it.
#pragma once

#include <optional>

#include "tests/rig/thermal_ball.h"

namespace hedgehog::rig {

/// `drawn` after a calibration: a thermometer that is up to 2 K off its windings and off by its
/// tolerance, and the heating plan, measured with the ball's own electronics. nullopt: refused.
std::optional<ThermalBallOptions> calibrated(const ThermalBallOptions& drawn);

}  // namespace hedgehog::rig
