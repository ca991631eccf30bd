// SPDX-License-Identifier: MIT
// `hedgehogctl forecast`: how long a current can flow.
#pragma once

#include <string>
#include <vector>

#include "protocol/methods/thermal.h"

namespace hedgehog::client {

/// `direction` as typed; empty: the worst coil.
std::vector<std::string> forecast_screen(const protocol::ForecastResult& forecast, double current_a,
                                         const std::string& direction);

}  // namespace hedgehog::client
