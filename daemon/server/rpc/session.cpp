// SPDX-License-Identifier: MIT
// hello, ping, connection.list
#include <spdlog/spdlog.h>

#include <algorithm>
#include <string>

#include "daemon/server/rpc/handlers.h"
#include "daemon/server/session/origin.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {

namespace {

/// Time after which a retry may succeed.
constexpr std::int64_t kFullMs = 1000;

}  // namespace

bool HandlerContext::has_previews() const noexcept {
  return std::any_of(
      previews.begin(), previews.end(), [](const auto& entry) { return !entry.second.expired(); });
}

std::size_t HandlerContext::connections() const noexcept {
  return static_cast<std::size_t>(std::count_if(
      sessions.begin(), sessions.end(), [](const auto& one) { return !one.second->locked; }));
}

std::optional<protocol::RpcError> HandlerContext::check_token(Session& session,
                                                              std::string_view secret) {
  auto refusal = tokens.log_in(session, secret, device_view.now().tick);
  if (!refusal) return refusal;
  ++counters.rejected["token"];
  // During a back-off, a line for each attempt would fill the log.
  if (!refusal->retry_after_ms) spdlog::warn("invalid token from {}", origin_text(session));
  return refusal;
}

std::optional<protocol::RpcError> HandlerContext::log_in(Session& session,
                                                         std::string_view secret) {
  const bool was_locked = session.locked;
  // Counted before this session is one of them.
  const std::size_t others = connections();
  if (auto refusal = check_token(session, secret)) return refusal;
  if (was_locked && others >= max_connections) {
    session.locked = true;
    ++counters.rejected["cap"];
    return protocol::busy("too many clients are connected", kFullMs);
  }
  spdlog::info("the token {} gives {} the role {}", session.token->name, origin_text(session),
               protocol::name(session.role));
  return std::nullopt;
}

Outcome handle(Call& call, const protocol::Hello& request) {
  if (call.session.ended) return Response(token_needed(call.session));
  if (request.token) {
    if (auto refusal = call.context.log_in(call.session, *request.token))
      return Response(*std::move(refusal));
  } else if (call.session.locked) {
    return Response(token_needed(call.session));
  }
  if (!request.client.empty()) call.session.client = request.client;
  const DeviceView& device_view = call.device_view();
  const control::StatusSnapshot& now = device_view.now();
  const config::Config& config = device_view.config();
  protocol::HelloResult result;
  result.version = HEDGEHOG_VERSION;
  result.connection = call.session.id;
  result.start_id = call.context.start_id;
  result.role = call.session.role;
  result.state = std::string(control::name(now.state));
  result.reason = device_view.reason_now();
  result.remedy = device_view.remedy_now();
  result.device = {config.device.name, config.device.model, device_view.simulated()};
  result.limits.current_a = device_view.limits().current_a;
  result.limits.continuous_a = device_view.limits().continuous_a;
  result.limits.felt_a = device_view.limits().felt_a;
  result.limits.burst_s = device_view.cold_burst_s();
  result.limits.telemetry_hz = config.telemetry_max_rate_hz;
  result.limits.effects = EffectRegistry::kMaxEach;
  result.limits.line_bytes = protocol::kMaxLineBytes;
  return Response(std::move(result));
}

Outcome handle(Call& call, const protocol::Ping&) {
  return Response(protocol::PingResult{call.device_view().time_ns(call.device_view().now().tick)});
}

Outcome handle(Call& call, const protocol::ConnectionList&) {
  HandlerContext& context = call.context;
  const model::Tick now = call.device_view().now().tick;
  protocol::ConnectionsResult result;
  for (const auto& [id, session] : context.sessions) {
    protocol::ConnectionInfo info;
    info.connection = id;
    if (!session->client.empty()) info.client = session->client;
    info.transport = session->transport;
    info.address = session->address;
    if (session->peer) {
      info.uid = session->peer->user;
      if (session->peer->process > 0) info.pid = session->peer->process;
    }
    info.role = session->role;
    info.since_s = static_cast<double>(now - session->since) * model::kTickSeconds;
    info.claimed = context.claim.holder(now) == id;
    for (const Effect* effect : context.effects.playing(id))
      info.effects.push_back(context.status.effect(*effect));
    result.connections.push_back(std::move(info));
  }
  return Response(std::move(result));
}

}  // namespace hedgehog::server
