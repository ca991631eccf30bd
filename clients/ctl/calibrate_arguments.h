// SPDX-License-Identifier: MIT
// The command line of `calibrate`.
#pragma once

#include "clients/ctl/calibrate/calibrate_verb.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
}

namespace hedgehog::client {

void add_calibrate_arguments(CLI::App& command, CalibrateOptions& options);

}  // namespace hedgehog::client
