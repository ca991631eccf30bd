// SPDX-License-Identifier: MIT
// A design as a device file of hedgehogd (config/devices.d/), so that a ball that was designed and
// printed can be driven.
#pragma once

#include <string>

#include "clients/common/problem.h"
#include "clients/design/input/design.h"

namespace hedgehog::design {

/// The device file of a ball of that name. Values that must be measured on the ball (coil matrix,
/// resistances) keep the defaults of its model. An error (65) for a design by positions: hedgehogd
/// accepts arrays by name only.
Result<std::string> device_text(const Design& design, const std::string& name);

}  // namespace hedgehog::design
