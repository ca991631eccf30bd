// SPDX-License-Identifier: MIT
// Requests to play -> plans.
#pragma once

#include <optional>

#include "daemon/server/device/device_view.h"
#include "daemon/server/effects/effect_plan.h"
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

/// Plan of a start, for playing or for computing only.
protocol::Result<EffectPlan> plan_start(const PlanContext& context,
                                        const protocol::EffectStart& request);
/// `plan` after `update`; unchanged key frames keep their range.
protocol::Result<EffectPlan> plan_update(const PlanContext& context, const EffectPlan& plan,
                                         const protocol::EffectParams& update);

/// The error of a spec in the world's frame while the orientation is unknown.
std::optional<protocol::RpcError> no_orientation(const DeviceView& device_view,
                                                 const model::EffectSpec& spec);

}  // namespace hedgehog::server
