// SPDX-License-Identifier: MIT
// effect.preview
#include <memory>
#include <string>
#include <utility>

#include "daemon/server/effects/planning.h"
#include "daemon/server/effects/preview.h"
#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {
namespace {

protocol::RpcError too_many_previews(bool own) {
  constexpr std::int64_t kRetryMs = 20;
  protocol::RpcError e =
      protocol::busy(own ? "this connection's last preview is still being worked out"
                         : "4 previews are being worked out already, and more would wait",
                     kRetryMs);
  e.limit = static_cast<std::int64_t>(own ? 1 : Preview::kMaxAtOnce);
  return e;
}

}  // namespace

Outcome handle(Call& call, const protocol::EffectPreview& request) {
  const DeviceView& device_view = call.device_view();
  if (device_view.now().state == control::State::kAbsent)
    return Response(*not_playable(device_view));
  if (auto refused = not_playable(device_view); refused && !device_view.temperature_known())
    return Response(*std::move(refused));
  const auto plan = plan_start(call.plan_context(), *request.start);
  if (plan.has_error()) return Response(plan.error());
  if (auto refused = no_orientation(device_view, plan->spec)) return Response(std::move(*refused));
  if (!call.expects_response) return Response(protocol::Done{});
  auto& running = call.context.previews;
  std::erase_if(running, [](const auto& entry) { return entry.second.expired(); });
  const bool own = running.contains(call.session.id);
  if (own || running.size() >= Preview::kMaxAtOnce) return Response(too_many_previews(own));
  auto preview = std::make_shared<Preview>(device_view, *plan);
  running.emplace(call.session.id, preview);
  // Each slice makes progress, so there is no timeout, however slow the machine is.
  return Deferred{[preview = std::move(preview)](HandlerContext&, bool) -> std::optional<Response> {
    if (!preview->advance(Preview::kSlice)) return std::nullopt;
    return Response(preview->result());
  }};
}

}  // namespace hedgehog::server
