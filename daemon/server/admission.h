// SPDX-License-Identifier: MIT
// What an effect will get, as of the last tick: the answer to whoever starts or updates one.
#pragma once

#include <optional>

#include "daemon/server/effect_registry.h"
#include "daemon/server/load.h"
#include "daemon/server/machine.h"
#include "protocol/error.h"
#include "protocol/results.h"

namespace hedgehog::server {

/// What is felt now: the highest priority, and the load of the effects that have it.
struct Felt {
  int priority = -1;
  Load load;
};

/// Effects that wait for their onset are left out, and so is `except` (nullptr: nobody).
Felt felt_now(const Machine& machine, EffectRegistry& effects, const Effect* except);

/// All fields but effect, slot and seq. `score`: the key frames of `spec`, nullptr when it has
/// none. `replaced` will be gone when `spec` begins.
protocol::Admission admission(const Machine& machine, EffectRegistry& effects,
                              const model::EffectSpec& spec, const KeyframeScore* score,
                              const Effect* replaced);

/// For `if_limited` "refuse": why `spec` cannot be delivered in full over its duration, or as long
/// as its lease; nullopt: it can. `admitted` is what `admission` said.
std::optional<protocol::RpcError> thermal_refusal(const Machine& machine,
                                                  const model::EffectSpec& spec,
                                                  const KeyframeScore* score,
                                                  const protocol::EffectParams& params,
                                                  const protocol::Admission& admitted);

}  // namespace hedgehog::server
