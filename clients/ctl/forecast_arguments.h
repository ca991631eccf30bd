// SPDX-License-Identifier: MIT
// The arguments of `forecast`.
#pragma once

#include "cli/program.h"
#include "clients/ctl/verbs/look_verbs.h"

namespace hedgehog::client {

/// `options` must outlive `forecast`.
void add_forecast_arguments(const cli::CommandSpec& forecast, ForecastOptions& options);

}  // namespace hedgehog::client
