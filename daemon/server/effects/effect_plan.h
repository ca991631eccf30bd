// SPDX-License-Identifier: MIT
// A request to play, resolved: its parameters complete, its spec, and its key frames.
#pragma once

#include <optional>

#include "daemon/server/device/device_view.h"
#include "daemon/server/effects/effect_registry.h"
#include "daemon/server/effects/effect_spec.h"
#include "protocol/methods.h"

namespace hedgehog::server {

class PatternLibrary;

/// What a request is resolved against, and by whom it was made.
struct PlanContext {
  const DeviceView& device_view;
  const PatternLibrary& patterns;
  protocol::Role role = protocol::Role::kObserve;
};

struct EffectPlan {
  /// Defaults filled in; without key frames, which `track` has.
  protocol::EffectParams params;
  Wave requested_wave;
  /// The place of its key frames is still open.
  model::EffectSpec spec;
  KeyframeTrackPtr track;
};

/// Of a start, for playing it or only for reckoning with it.
protocol::Result<EffectPlan> plan_start(const PlanContext& context,
                                        const protocol::EffectStart& request);
/// Of `effect` after `update`; unchanged key frames keep their place.
protocol::Result<EffectPlan> plan_update(const PlanContext& context, const Effect& effect,
                                         const protocol::EffectParams& update);

/// The error of a spec in the world's frame while the orientation is unknown.
std::optional<protocol::RpcError> no_orientation(const DeviceView& device_view,
                                                 const model::EffectSpec& spec);

}  // namespace hedgehog::server
