// SPDX-License-Identifier: MIT
// A design as the device file that hedgehogd reads (config/devices.d/), so that a ball that was
// designed and printed can be driven.
#pragma once

#include <string>

#include "clients/common/problem.h"
#include "clients/design/input/design.h"

namespace hedgehog::design {

/// The file for a ball of that name. What has to be measured on the ball itself (coil matrix,
/// resistances) is left to the kind of ball. Complains (65) about a design that is a list of
/// positions: hedgehogd knows the arrays by name.
Result<std::string> device_text(const Design& design, const std::string& name);

}  // namespace hedgehog::design
