// SPDX-License-Identifier: MIT
// hello, ping, connection.list, telemetry.*, events.*
#include <algorithm>
#include <cmath>
#include <string>

#include "daemon/server/handlers.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {

Outcome hello(Call& call, const protocol::Hello& request) {
  if (request.token) {
    return Answer(protocol::error(protocol::ErrorCode::kUnauthorized,
                                  "token: this server knows no tokens; connect without one"));
  }
  if (!request.client.empty()) {
    call.session.client = request.client;
  }
  const Machine& machine = call.machine();
  const control::StatusSnapshot& now = machine.now();
  const config::Config& config = machine.config();
  protocol::HelloResult result;
  result.version = HEDGEHOG_VERSION;
  result.connection = call.session.id;
  result.role = call.session.role;
  result.state = std::string(control::name(now.state));
  result.reason = reason_name(now.reason);
  result.remedy = machine.remedy_now();
  result.device = {config.device.name, config.device.model, machine.simulated()};
  result.limits.current_a = machine.limits().current_a;
  result.limits.continuous_a = machine.limits().continuous_a;
  result.limits.felt_a = machine.limits().felt_a;
  result.limits.telemetry_hz = config.telemetry_max_rate_hz;
  result.limits.effects = EffectRegistry::kMaxEach;
  result.limits.line_bytes = protocol::kMaxLineBytes;
  return Answer(std::move(result));
}

Outcome ping(Call& call, const protocol::Ping&) {
  return Answer(protocol::PingResult{call.machine().time_ns(call.machine().now().tick)});
}

Outcome connection_list(Call& call, const protocol::ConnectionList&) {
  Services& services = call.services;
  const model::Tick now = call.machine().now().tick;
  protocol::ConnectionsResult result;
  for (const auto& [id, session] : services.sessions) {
    protocol::ConnectionInfo info;
    info.connection = id;
    if (!session->client.empty()) {
      info.client = session->client;
    }
    info.transport = session->transport;
    info.address = session->address;
    info.role = session->role;
    info.since_s = static_cast<double>(now - session->since) * model::kTickSeconds;
    info.claimed = services.claim.holder(now) == id;
    for (const Effect* effect : services.effects.playing(id)) {
      info.effects.push_back(services.status.effect(*effect));
    }
    result.connections.push_back(std::move(info));
  }
  return Answer(std::move(result));
}

Outcome telemetry_subscribe(Call& call, const protocol::TelemetrySubscribe& request) {
  const double most_hz = call.machine().config().telemetry_max_rate_hz;
  if (request.rate_hz > most_hz) {
    return Answer(protocol::out_of_range("rate_hz", most_hz, request.rate_hz));
  }
  const auto period = static_cast<model::Tick>(std::lround(1000.0 / request.rate_hz));
  call.session.telemetry = {request.fields, std::max<model::Tick>(1, period),
                            call.machine().now().tick};
  return Answer(protocol::TelemetryResult{request.rate_hz, request.fields});
}

Outcome telemetry_unsubscribe(Call& call, const protocol::TelemetryUnsubscribe&) {
  call.session.telemetry.reset();
  return Answer(protocol::Done{});
}

Outcome events_subscribe(Call& call, const protocol::EventsSubscribe& request) {
  call.session.events = {request.types, request.scope};
  const control::StatusSnapshot& now = call.machine().now();
  return Answer(protocol::EventsResult{std::string(control::name(now.state)),
                                       reason_name(now.reason), now.derating, now.limit_a});
}

Outcome events_unsubscribe(Call& call, const protocol::EventsUnsubscribe&) {
  call.session.events.reset();
  return Answer(protocol::Done{});
}

}  // namespace hedgehog::server
