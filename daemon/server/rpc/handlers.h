// SPDX-License-Identifier: MIT
// The methods of the protocol. `carry_out` looks the method up in one sorted table; the handlers
// themselves stand in the file that has the name of their namespace: effect.cpp has effect.*.
#pragma once

#include "daemon/server/rpc/handler_context.h"
#include "protocol/requests.h"

namespace hedgehog::server {

/// Checks the role, then calls the handler. io thread.
Outcome carry_out(Call& call, const protocol::Request& request);

Outcome hello(Call& call, const protocol::Hello& request);
Outcome ping(Call& call, const protocol::Ping& request);
Outcome connection_list(Call& call, const protocol::ConnectionList& request);

Outcome effect_start(Call& call, const protocol::EffectStart& request);
Outcome effect_update(Call& call, const protocol::EffectUpdate& request);
Outcome effect_stop(Call& call, const protocol::EffectStop& request);
Outcome effect_stop_all(Call& call, const protocol::EffectStopAll& request);

Outcome device_describe(Call& call, const protocol::DeviceDescribe& request);
Outcome device_list(Call& call, const protocol::DeviceList& request);
Outcome device_status(Call& call, const protocol::DeviceStatus& request);
Outcome device_arm(Call& call, const protocol::DeviceArm& request);
Outcome device_emergency_stop(Call& call, const protocol::DeviceEmergencyStop& request);
Outcome device_claim(Call& call, const protocol::DeviceClaim& request);
Outcome device_release(Call& call, const protocol::DeviceRelease& request);
Outcome output_set_gain(Call& call, const protocol::OutputSetGain& request);
Outcome thermal_forecast(Call& call, const protocol::ThermalForecast& request);

Outcome orientation_set(Call& call, const protocol::OrientationSet& request);
Outcome orientation_recenter(Call& call, const protocol::OrientationRecenter& request);
Outcome sim_set(Call& call, const protocol::SimSet& request);
Outcome sim_truth(Call& call, const protocol::SimTruth& request);

Outcome effect_preview(Call& call, const protocol::EffectPreview& request);
Outcome events_history(Call& call, const protocol::EventsHistory& request);
Outcome pattern_list(Call& call, const protocol::PatternList& request);
Outcome pattern_get(Call& call, const protocol::PatternGet& request);
Outcome pattern_put(Call& call, const protocol::PatternPut& request);
Outcome pattern_remove(Call& call, const protocol::PatternRemove& request);

Outcome telemetry_subscribe(Call& call, const protocol::TelemetrySubscribe& request);
Outcome telemetry_unsubscribe(Call& call, const protocol::TelemetryUnsubscribe& request);
Outcome events_subscribe(Call& call, const protocol::EventsSubscribe& request);
Outcome events_unsubscribe(Call& call, const protocol::EventsUnsubscribe& request);

/// Why the outbox has no room for `count` more: the batch asks for too much, or "busy: the queue to
/// the control loop is full; nothing was changed".
protocol::RpcError queue_full(const Outbox& outbox, std::size_t count = 1);
/// Why nothing can be played now: no ball, or not armed; nullopt: it can.
std::optional<protocol::RpcError> not_playable(const DeviceView& device_view);
/// Another client has the ball for itself; nullopt: none has.
std::optional<protocol::RpcError> claimed(const Call& call);
/// The error of a request that waited too long for a tick.
protocol::RpcError control_stuck();
/// `effect` ends at the next tick.
void request_stop(HandlerContext& context, Effect& effect, control::EndReason reason);

}  // namespace hedgehog::server
