// SPDX-License-Identifier: MIT
// orientation.*
#include <string>
#include <utility>

#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {
namespace {

using protocol::RpcError;

RpcError no_imu(std::string_view field) {
  return protocol::device_absent(field, "no orientation sensor is connected", "imu");
}

}  // namespace

Outcome handle(Call& call, const protocol::OrientationSet& request) {
  HandlerContext& context = call.context;
  if (call.device_view().config().imu != config::ImuType::kExternal) {
    RpcError e = protocol::error(
        protocol::ErrorCode::kUnsupported,
        call.device_view().config().imu == config::ImuType::kSimulator
            ? "orientation.set: the sensor is simulated; turn the ball with sim.set"
            : "orientation.set: needs \"imu\": {\"type\": \"external\"} in the configuration");
    return Response(std::move(e));
  }
  if (context.orientation_feeder == 0) context.orientation_feeder = call.session.id;
  if (context.orientation_feeder != call.session.id) {
    return Response(protocol::error(protocol::ErrorCode::kClaimed,
                                    "claimed: another client sets the orientation"));
  }
  call.device_view().set_orientation(request.quaternion);
  return Response(protocol::Done{});
}

Outcome handle(Call& call, const protocol::OrientationRecenter& request) {
  if (!call.device_view().now().orientation_present) return Response(no_imu("orientation"));
  const auto seq =
      call.device_view().outbox().add(call.session.id, control::Recenter{request.azimuth_deg});
  if (!seq) return Response(queue_full(call.device_view().outbox()));
  return Deferred{[seq = *seq](HandlerContext& context, bool give_up) -> std::optional<Response> {
    if (context.device_view.now().applied_seq >= seq)
      return Response(protocol::RecenterResult{context.device_view.now().yaw_offset_deg});
    return give_up ? std::optional<Response>(control_stuck()) : std::nullopt;
  }};
}

}  // namespace hedgehog::server
