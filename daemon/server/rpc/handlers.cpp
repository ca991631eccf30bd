// SPDX-License-Identifier: MIT
#include "daemon/server/rpc/handlers.h"

#include <variant>

namespace hedgehog::server {

Outcome carry_out(Call& call, const protocol::Request& request) {
  const protocol::MethodInfo& method = protocol::info(protocol::method_of(request));
  if (call.session.locked && !std::holds_alternative<protocol::Hello>(request))
    return Response(token_needed(call.session));
  if (method.role && call.session.role < *method.role)
    return Response(protocol::forbidden("method", method.name, *method.role, call.session.role));
  return std::visit([&](const auto& one) { return handle(call, one); }, request);
}

protocol::RpcError queue_full(const Outbox& outbox, std::size_t count) {
  protocol::RpcError e =
      protocol::busy("the queue to the control loop is full; nothing was changed", 1);
  if (outbox.exceeds_group(count)) {
    e = protocol::busy(
        "a batch makes 64 commands at most, one for every 11 new key frames among them; nothing "
        "was changed, send this in a separate line",
        0);
    e.retry_after_ms.reset();
    e.limit = std::int64_t{control::kMaxCommandsPerTick};
  }
  return e;
}

std::optional<protocol::RpcError> not_playable(const DeviceView& device_view) {
  const control::StatusSnapshot& now = device_view.now();
  if (now.state == control::State::kArmed) return std::nullopt;
  const std::string reason(control::name(now.reason));
  const std::string remedy = device_view.remedy_now().value_or("");
  if (now.state == control::State::kAbsent) {
    protocol::RpcError e = protocol::device_absent("device", "no ball answers. " + remedy, "board");
    e.state = std::string(control::name(now.state));
    e.reason = reason;
    e.remedy = remedy;
    return e;
  }
  return protocol::not_armed(control::name(now.state), reason, remedy);
}

std::optional<protocol::RpcError> claimed(const Call& call) {
  const model::Tick now = call.device_view().now().tick;
  if (!call.context.claim.excludes(call.session.id, now)) return std::nullopt;
  protocol::RpcError e = protocol::error(protocol::ErrorCode::kClaimed,
                                         "claimed: another client has exclusive use of the ball");
  e.retry_after_ms = call.context.claim.remaining(now);
  return e;
}

protocol::RpcError control_stuck() {
  return protocol::busy("the control loop does not answer", 1000);
}

void request_stop(HandlerContext& context, Effect& effect, control::EndReason reason) {
  context.device_view.mailbox().stops.request(effect.id, effect.place, reason);
  effect.ending = true;
}

}  // namespace hedgehog::server
