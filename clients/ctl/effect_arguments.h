// SPDX-License-Identifier: MIT
// The options of the verbs that play.
#pragma once

#include "cli/program.h"
#include "clients/ctl/verbs/play_verbs.h"
#include "model/effect/effect.h"

namespace hedgehog::client {

/// Adds every parameter of `method` to `command` as an option, the most common one as a positional
/// argument too, and --for. Values are stored in `options`, which must outlive `command`.
void add_effect_arguments(const cli::CommandSpec& command, model::EffectMethod method,
                          PlayOptions& options);

}  // namespace hedgehog::client
