// SPDX-License-Identifier: MIT
// Expected delivery of an effect as of the last tick: the response to starting or updating one.
#pragma once

#include <optional>

#include "daemon/server/device/device_view.h"
#include "daemon/server/effects/effect_registry.h"
#include "daemon/server/effects/load.h"
#include "protocol/methods.h"
#include "protocol/wire/error.h"

namespace hedgehog::server {

/// The effects felt now: the highest priority, and the load of its effects.
struct Felt {
  int priority = -1;
  Load load;
};

/// Without effects that wait for their onset, and without `except` (nullptr: none).
Felt felt_now(const DeviceView& device_view, EffectRegistry& effects, const Effect* except);

/// All fields but effect, slot and seq. `track`: the key frames of `spec`, nullptr if it has none.
/// `replaced` ends when `spec` starts.
protocol::Admission admission(const DeviceView& device_view, EffectRegistry& effects,
                              const model::EffectSpec& spec, const KeyframeTrack* track,
                              const Effect* replaced);

/// For `if_limited` "refuse": the reason for which `spec` cannot be delivered in full over its
/// duration or lease; nullopt: it can. `admitted` is the result of `admission`.
std::optional<protocol::RpcError> thermal_refusal(const DeviceView& device_view,
                                                  const model::EffectSpec& spec,
                                                  const KeyframeTrack* track,
                                                  const protocol::EffectParams& params,
                                                  const protocol::Admission& admitted);

}  // namespace hedgehog::server
