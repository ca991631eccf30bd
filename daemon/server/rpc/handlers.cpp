// SPDX-License-Identifier: MIT
#include "daemon/server/rpc/handlers.h"

#include <array>

#include "protocol/method.h"

namespace hedgehog::server {
namespace {

using protocol::Method;

using Handler = Outcome (*)(Call&, const protocol::Request&);

template <class T, Outcome (*F)(Call&, const T&)>
Outcome unpacked(Call& call, const protocol::Request& request) {
  return F(call, std::get<T>(request));
}

struct Row {
  Method method;
  Handler handler;
};

constexpr Handler kStart = unpacked<protocol::EffectStart, effect_start>;

constexpr std::array<Row, protocol::kMethods.size()> kRows{{
    {Method::kConnectionList, unpacked<protocol::ConnectionList, connection_list>},
    {Method::kDeviceArm, unpacked<protocol::DeviceArm, device_arm>},
    {Method::kDeviceClaim, unpacked<protocol::DeviceClaim, device_claim>},
    {Method::kDeviceDescribe, unpacked<protocol::DeviceDescribe, device_describe>},
    {Method::kDeviceEmergencyStop, unpacked<protocol::DeviceEmergencyStop, device_emergency_stop>},
    {Method::kDeviceList, unpacked<protocol::DeviceList, device_list>},
    {Method::kDeviceRelease, unpacked<protocol::DeviceRelease, device_release>},
    {Method::kDeviceStatus, unpacked<protocol::DeviceStatus, device_status>},
    {Method::kEffectCircle, kStart},
    {Method::kEffectHold, kStart},
    {Method::kEffectPlay, kStart},
    {Method::kEffectPreview, unpacked<protocol::EffectPreview, effect_preview>},
    {Method::kEffectPulse, kStart},
    {Method::kEffectStop, unpacked<protocol::EffectStop, effect_stop>},
    {Method::kEffectStopAll, unpacked<protocol::EffectStopAll, effect_stop_all>},
    {Method::kEffectUpdate, unpacked<protocol::EffectUpdate, effect_update>},
    {Method::kEffectVibrate, kStart},
    {Method::kEventsHistory, unpacked<protocol::EventsHistory, events_history>},
    {Method::kEventsSubscribe, unpacked<protocol::EventsSubscribe, events_subscribe>},
    {Method::kEventsUnsubscribe, unpacked<protocol::EventsUnsubscribe, events_unsubscribe>},
    {Method::kHello, unpacked<protocol::Hello, hello>},
    {Method::kOrientationRecenter, unpacked<protocol::OrientationRecenter, orientation_recenter>},
    {Method::kOrientationSet, unpacked<protocol::OrientationSet, orientation_set>},
    {Method::kOutputSetGain, unpacked<protocol::OutputSetGain, output_set_gain>},
    {Method::kPatternGet, unpacked<protocol::PatternGet, pattern_get>},
    {Method::kPatternList, unpacked<protocol::PatternList, pattern_list>},
    {Method::kPatternPut, unpacked<protocol::PatternPut, pattern_put>},
    {Method::kPatternRemove, unpacked<protocol::PatternRemove, pattern_remove>},
    {Method::kPing, unpacked<protocol::Ping, ping>},
    {Method::kSimSet, unpacked<protocol::SimSet, sim_set>},
    {Method::kSimTruth, unpacked<protocol::SimTruth, sim_truth>},
    {Method::kTelemetrySubscribe, unpacked<protocol::TelemetrySubscribe, telemetry_subscribe>},
    {Method::kTelemetryUnsubscribe,
     unpacked<protocol::TelemetryUnsubscribe, telemetry_unsubscribe>},
    {Method::kThermalForecast, unpacked<protocol::ThermalForecast, thermal_forecast>},
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (kRows[i].method != protocol::kMethods[i].method) return false;
  return true;
}
static_assert(in_order(), "kRows follows protocol::kMethods");

}  // namespace

Outcome carry_out(Call& call, const protocol::Request& request) {
  const protocol::MethodInfo& method = protocol::info(protocol::method_of(request));
  if (method.role && call.session.role < *method.role)
    return Answer(protocol::forbidden("method", method.name, *method.role, call.session.role));
  return kRows[static_cast<std::size_t>(method.method)].handler(call, request);
}

protocol::RpcError queue_full(const Outbox& outbox, std::size_t count) {
  protocol::RpcError e =
      protocol::busy("the queue to the control loop is full; nothing was changed", 1);
  if (outbox.exceeds_group(count)) {
    e = protocol::busy(
        "a batch makes 64 commands at most, one for every 11 new key frames among them; nothing "
        "was changed, send this in a line of its own",
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
                                         "claimed: another client has the ball for itself");
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
