// SPDX-License-Identifier: MIT
// The options of `hedgehogctl record`.
#pragma once

#include "clients/ctl/verbs/record_verb.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
}

namespace hedgehog::client {

/// Values are stored in `options`, which must outlive `command`.
void add_record_arguments(CLI::App& command, RecordOptions& options);

}  // namespace hedgehog::client
