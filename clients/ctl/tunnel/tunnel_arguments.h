// SPDX-License-Identifier: MIT
// The command line of `tunnel`.
#pragma once

#include "cli/program.h"
#include "clients/ctl/tunnel/tunnel_verb.h"

namespace hedgehog::client {

/// `general`: --address, which the argument ADDRESS replaces; it is stored in `common`.
void add_tunnel_arguments(const cli::CommandSpec& tunnel, const cli::OptionSpec& general,
                          CommonOptions& common, TunnelOptions& options);

}  // namespace hedgehog::client
