// SPDX-License-Identifier: MIT
// A ball with the device file that `hedgehogctl calibrate --thermal` writes for it.
#pragma once

#include <optional>

#include "tests/rig/thermal_ball.h"

namespace hedgehog::rig {

/// `drawn` after a calibration: with a thermometer that deviates by up to 2 K from its windings
/// plus its tolerance, and the heating plan, measured by the ball's own electronics. nullopt: the
/// fit was rejected.
std::optional<ThermalBallOptions> calibrated(const ThermalBallOptions& drawn);

}  // namespace hedgehog::rig
