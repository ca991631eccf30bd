// SPDX-License-Identifier: MIT
// The command line of `token`.
#pragma once

#include <functional>

#include "cli/program.h"
#include "clients/ctl/token/token_verb.h"

namespace hedgehog::client {

using TokenVerb = int (*)(const CommonOptions&, const TokenOptions&);

/// Adds add, list, revoke and certificate to `token`; `chosen` is called with the selected one.
void add_token_arguments(const cli::CommandSpec& token, TokenOptions& options,
                         const std::function<void(TokenVerb)>& chosen);

}  // namespace hedgehog::client
