// SPDX-License-Identifier: MIT
// The options of the verbs that play.
#pragma once

#include "clients/ctl/verbs/play_verbs.h"
#include "model/effect/effect.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
}

namespace hedgehog::client {

/// Gives `command` every parameter of `method` as an option, what is given most often as an
/// argument too, and --for. What is given goes to `options`, which must outlive `command`.
void add_effect_arguments(CLI::App& command, model::EffectMethod method, PlayOptions& options);

}  // namespace hedgehog::client
