// SPDX-License-Identifier: MIT
// Handlers of the methods. A handler is in the file with the name of its namespace: effect.cpp
// contains effect.*; session.cpp contains hello, ping, connection.list.
#pragma once

#include "daemon/server/rpc/handler_context.h"
#include "protocol/methods.h"

namespace hedgehog::server {

/// Checks the role, then calls the handler. io thread.
Outcome carry_out(Call& call, const protocol::Request& request);

Outcome handle(Call& call, const protocol::Hello& request);
Outcome handle(Call& call, const protocol::Ping& request);
Outcome handle(Call& call, const protocol::ConnectionList& request);

Outcome handle(Call& call, const protocol::EffectStart& request);
Outcome handle(Call& call, const protocol::EffectUpdate& request);
Outcome handle(Call& call, const protocol::EffectStop& request);
Outcome handle(Call& call, const protocol::EffectStopAll& request);
Outcome handle(Call& call, const protocol::EffectPreview& request);
Outcome handle(Call& call, const protocol::EffectLatency& request);

Outcome handle(Call& call, const protocol::DeviceDescribe& request);
Outcome handle(Call& call, const protocol::DeviceList& request);
Outcome handle(Call& call, const protocol::DeviceStatus& request);
Outcome handle(Call& call, const protocol::DeviceArm& request);
Outcome handle(Call& call, const protocol::DeviceEmergencyStop& request);
Outcome handle(Call& call, const protocol::DeviceEnterBootLoader& request);
Outcome handle(Call& call, const protocol::DeviceClaim& request);
Outcome handle(Call& call, const protocol::DeviceRelease& request);

Outcome handle(Call& call, const protocol::OutputSetGain& request);
Outcome handle(Call& call, const protocol::ThermalForecast& request);
Outcome handle(Call& call, const protocol::OrientationSet& request);
Outcome handle(Call& call, const protocol::OrientationRecenter& request);
Outcome handle(Call& call, const protocol::SimSet& request);
Outcome handle(Call& call, const protocol::SimTruth& request);

Outcome handle(Call& call, const protocol::EventsHistory& request);
Outcome handle(Call& call, const protocol::EventsSubscribe& request);
Outcome handle(Call& call, const protocol::EventsUnsubscribe& request);
Outcome handle(Call& call, const protocol::TelemetryHistory& request);
Outcome handle(Call& call, const protocol::TelemetrySubscribe& request);
Outcome handle(Call& call, const protocol::TelemetryUnsubscribe& request);

Outcome handle(Call& call, const protocol::PatternList& request);
Outcome handle(Call& call, const protocol::PatternGet& request);
Outcome handle(Call& call, const protocol::PatternPut& request);
Outcome handle(Call& call, const protocol::PatternRemove& request);

/// Error of an outbox without capacity for `count` more: the batch is too large, or "busy: the
/// queue to the control loop is full; nothing was changed".
protocol::RpcError queue_full(const Outbox& outbox, std::size_t count = 1);
/// Error if nothing can be played now: no ball, or not armed; nullopt: it can.
std::optional<protocol::RpcError> not_playable(const DeviceView& device_view);
/// Error if another client holds the claim; nullopt: none does.
std::optional<protocol::RpcError> claimed(const Call& call);
/// Error of a request that waited too long for a tick.
protocol::RpcError control_stuck();
/// Ends `effect` at the next tick.
void request_stop(HandlerContext& context, Effect& effect, control::EndReason reason);

}  // namespace hedgehog::server
