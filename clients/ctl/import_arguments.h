// SPDX-License-Identifier: MIT
// The arguments of `patterns import`.
#pragma once

#include "cli/program.h"
#include "clients/ctl/verbs/pattern_verbs.h"

namespace hedgehog::client {

/// `options` must outlive the verb.
void add_import_arguments(const cli::CommandSpec& command, ImportOptions& options);

}  // namespace hedgehog::client
