// SPDX-License-Identifier: MIT
// A resolved request to play: its complete parameters, its spec, and its key frames.
#pragma once

#include <optional>

#include "daemon/server/device/device_view.h"
#include "daemon/server/effects/effect_registry.h"
#include "daemon/server/effects/effect_spec.h"
#include "protocol/methods.h"

namespace hedgehog::server {

class PatternLibrary;

/// Context in which a request is resolved, and the role of its client.
struct PlanContext {
  const DeviceView& device_view;
  const PatternLibrary& patterns;
  protocol::Role role = protocol::Role::kObserve;
};

struct EffectPlan {
  protocol::EffectParams params;  // with defaults; key frames are in track
  Wave requested_wave;
  model::EffectSpec spec;  // the range of its key frames is allocated later
  KeyframeTrackPtr track;
};

/// Plan of a start, for playing or for computing only.
protocol::Result<EffectPlan> plan_start(const PlanContext& context,
                                        const protocol::EffectStart& request);
/// Plan of `effect` after `update`; unchanged key frames keep their range.
protocol::Result<EffectPlan> plan_update(const PlanContext& context, const Effect& effect,
                                         const protocol::EffectParams& update);

/// The error of a spec in the world's frame while the orientation is unknown.
std::optional<protocol::RpcError> no_orientation(const DeviceView& device_view,
                                                 const model::EffectSpec& spec);

}  // namespace hedgehog::server
