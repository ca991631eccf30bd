// SPDX-License-Identifier: MIT
// The arguments of `forecast`.
#pragma once

#include <CLI/CLI.hpp>

#include "clients/ctl/verbs/look_verbs.h"

namespace hedgehog::client {

/// `options` must outlive `forecast`.
void add_forecast_arguments(CLI::App& forecast, ForecastOptions& options);

}  // namespace hedgehog::client
