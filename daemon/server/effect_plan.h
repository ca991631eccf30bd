// SPDX-License-Identifier: MIT
// What a request to play comes to: its parameters complete, its spec, and its key frames.
#pragma once

#include <optional>

#include "daemon/server/effect_registry.h"
#include "daemon/server/effect_spec.h"
#include "daemon/server/services.h"
#include "protocol/requests.h"

namespace hedgehog::server {

struct EffectPlan {
  /// Defaults filled in; without key frames, which `score` has.
  protocol::EffectParams params;
  Wave said_wave;
  /// Where its key frames will stand is still open.
  model::EffectSpec spec;
  ScorePtr score;
};

/// Of a start, for playing it or only for reckoning with it.
protocol::Result<EffectPlan> plan_start(const Call& call, const protocol::EffectStart& request);
/// Of `effect` after `update`; the same key frames still stand where they are.
protocol::Result<EffectPlan> plan_update(const Call& call, const Effect& effect,
                                         const protocol::EffectParams& update);

/// What speaks against a spec in the world's frame while nothing tells how the ball lies.
std::optional<protocol::RpcError> no_orientation(const Machine& machine,
                                                 const model::EffectSpec& spec);

}  // namespace hedgehog::server
