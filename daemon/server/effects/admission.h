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

/// An effect as it will be delivered, without the costly forecast of how long (up to 0.5 ms).
struct Delivery {
  /// All fields but effect, slot, seq, and `headroom_s` if `forecast_of` is set.
  protocol::Admission admission;
  /// The currents of all effects of its priority; nullopt: `headroom_s` needs no forecast.
  std::optional<model::RequestedCurrents> forecast_of;
};

/// `track`: the key frames of `spec`, nullptr if it has none. `replaced` ends when `spec` starts.
Delivery expected_delivery(const DeviceView& device_view, EffectRegistry& effects,
                           const model::EffectSpec& spec, const KeyframeTrack* track,
                           const Effect* replaced);

/// The complete admission of `delivery`, as of the same snapshot.
protocol::Admission with_headroom(const DeviceView& device_view, Delivery delivery);

/// For `if_limited` "refuse": the reason for which `spec` cannot be delivered in full over its
/// duration or lease; nullopt: it can. `admitted` is the result of `with_headroom`.
std::optional<protocol::RpcError> thermal_refusal(const DeviceView& device_view,
                                                  const model::EffectSpec& spec,
                                                  const KeyframeTrack* track,
                                                  const protocol::EffectParams& params,
                                                  const protocol::Admission& admitted);

}  // namespace hedgehog::server
