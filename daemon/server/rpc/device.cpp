// SPDX-License-Identifier: MIT
// device.*, output.set_gain
#include <chrono>
#include <string>
#include <utility>

#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {
namespace {

/// Clients wait at least 1 s for the response to a stop; half of it is left for the disk.
constexpr std::chrono::milliseconds kLatchTimeout{500};

/// The board has 300 ticks to confirm an arm request (control::StateMachine::kArmTimeout).
constexpr model::Tick kArmTimeout = 400;

protocol::StateResult state_result(const DeviceView& device_view, std::uint64_t seq) {
  const control::StatusSnapshot& now = device_view.now();
  return {std::string(control::name(now.state)), device_view.reason_now(), device_view.remedy_now(),
          seq};
}

/// The coils are off and control has stopped: the latch applies to the next start, as set by
/// control::StateMachine::emergency_stop.
protocol::StateResult stopped_while_stopping(DeviceView& device_view) {
  const control::StatusSnapshot& now = device_view.now();
  protocol::StateResult result = state_result(device_view, device_view.outbox().last_seq());
  if (now.state == control::State::kArmed || now.state == control::State::kDisarmed) {
    const control::Reason latch =
        now.latch != control::Reason::kNone ? now.latch : control::Reason::kEmergencyStop;
    result.state = control::name(control::State::kDisarmed);
    result.reason = reason_name(latch);
    result.remedy = remedy(control::State::kDisarmed, latch, device_view.remedy_facts());
  }
  return result;
}

/// The coils are off. The latch on disk matters only if the daemon is killed or the machine loses
/// power.
protocol::StateResult stopped(HandlerContext& context, std::uint64_t latch_write) {
  DeviceView& device_view = context.device_view;
  protocol::StateResult result = context.stopping
                                     ? stopped_while_stopping(device_view)
                                     : state_result(device_view, device_view.outbox().last_seq());
  result.on_disk = context.state_store.latch_persisted(latch_write) == Persisted::kYes;
  return result;
}

protocol::RpcError arm_refused(const DeviceView& device_view) {
  const control::StatusSnapshot& now = device_view.now();
  const control::Reason why =
      now.arming_blocker != control::Reason::kNone ? now.arming_blocker : now.reason;
  protocol::RpcError refused = protocol::not_armed(
      control::name(now.state), control::name(why),
      remedy(control::State::kTripped, why, device_view.remedy_facts()).value_or(""));
  if (now.rearm_wait > 0) refused.retry_after_ms = now.rearm_wait;
  return refused;
}

}  // namespace

Outcome handle(Call& call, const protocol::DeviceDescribe&) {
  const DeviceView& device_view = call.device_view();
  const config::Config& config = device_view.config();
  const model::DeviceModel& device = config.device;
  protocol::Description d;
  d.name = device.name;
  d.model = device.model;
  d.simulated = device_view.simulated();
  d.arrangement = device_view.array().arrangement;
  for (const model::Pin& pin : device_view.array().pins) {
    const double rest_mm = device_view.pin_curves().rest_mm(static_cast<std::size_t>(pin.id));
    d.pins.push_back({pin.id, pin.position, pin.ring, rest_mm});
  }
  for (std::size_t row = 0; row < d.coils.matrix.size(); ++row)
    d.coils.matrix[row] = device.coils.matrix.row[row];
  d.coils.r25_ohm = device.coils.r25_ohm;
  d.coils.inductance_h = device.coils.inductance_h;
  d.coils.supply_v = device.coils.supply_v;
  d.coils.measured.emplace();
  for (int coil = 0; coil < model::kCoils; ++coil) {
    protocol::WindingDescription winding;
    if (const auto r25 = device_view.r25(coil))
      winding = {r25->ohm, r25->from_file, r25->from_kept};
    d.coils.measured->push_back(winding);
  }
  d.thermal = device.thermal;
  d.uncertainty = device.uncertainty;
  d.limits = device_view.limits();
  d.calibration.force_n_per_a = device.force_slope_n_a;
  d.gain = device_view.gain();
  d.board.backend = d.simulated ? "simulator" : "usb";
  d.board.present = device_view.now().board_present;
  BoardInfo board = device_view.board();
  d.board.serial = std::move(board.serial);
  d.board.firmware = std::move(board.firmware);
  d.board.protocol = device_view.board_protocol();
  d.imu.type = config::name(config.imu);
  d.imu.present = device_view.now().orientation_present;
  return Response(std::move(d));
}

Outcome handle(Call& call, const protocol::DeviceList&) {
  DeviceScanner* devices = call.context.devices;
  if (devices == nullptr) return Response(protocol::DevicesResult{});
  const DeviceScanner::Ready ready = devices->scan();
  const protocol::RpcError slow = protocol::busy("looking for devices takes too long", 1000);
  if (!ready) return Response(slow);
  return Deferred{[ready, slow](HandlerContext& context, bool give_up) -> std::optional<Response> {
    if (auto found = ready()) {
      for (protocol::SeenDevice& device : found->devices)
        if (device.use == "board")
          if (auto version = context.device_view.board_protocol()) device.protocol = *version;
      return Response(*std::move(found));
    }
    return give_up ? std::optional<Response>(slow) : std::nullopt;
  }};
}

Outcome handle(Call& call, const protocol::DeviceStatus&) {
  return Response(call.context.status.status(false));
}

Outcome handle(Call& call, const protocol::DeviceArm&) {
  DeviceView& device_view = call.device_view();
  if (device_view.now().state == control::State::kArmed)
    return Response(state_result(device_view, device_view.outbox().last_seq()));
  if (device_view.now().state == control::State::kAbsent)
    return Response(*not_playable(device_view));
  const auto seq = device_view.outbox().add(
      call.session.id,
      control::Arm{device_view.mailbox().emergency_generation.load(std::memory_order_acquire)});
  if (!seq) return Response(queue_full(device_view.outbox()));
  return Deferred{[seq = *seq, since = model::Tick{-1}](
                      HandlerContext& context, bool give_up) mutable -> std::optional<Response> {
    const control::StatusSnapshot& now = context.device_view.now();
    const bool applied = now.applied_seq >= seq;
    if (applied && now.state == control::State::kArmed)
      return Response(state_result(context.device_view, seq));
    if (give_up) return Response(control_stuck());
    if (!applied) return std::nullopt;
    since = since < 0 ? now.tick : since;
    const bool refused = now.arming_blocker != control::Reason::kNone;
    if (!refused && now.tick - since < kArmTimeout) return std::nullopt;
    return Response(arm_refused(context.device_view));
  }};
}

Outcome handle(Call& call, const protocol::DeviceEmergencyStop&) {
  DeviceView& device_view = call.device_view();
  device_view.mailbox().emergency_generation.fetch_add(1, std::memory_order_acq_rel);
  const std::uint64_t write =
      call.context.state_store.persist_latch(control::Reason::kEmergencyStop);
  if (call.context.stopping &&
      call.context.state_store.latch_persisted(write) != Persisted::kPending)
    return Response(stopped(call.context, write));
  // The snapshot may be a tick older than the request.
  const model::Tick seen = device_view.now().tick + 2;
  const auto until = std::chrono::steady_clock::now() + kLatchTimeout;
  return Deferred{[seen, write, until](HandlerContext& context,
                                       bool give_up) -> std::optional<Response> {
    const control::StatusSnapshot& now = context.device_view.now();
    const bool off = context.stopping || (now.tick >= seen && now.state != control::State::kArmed);
    if (!off) return give_up ? std::optional<Response>(control_stuck()) : std::nullopt;
    const bool waits = context.state_store.latch_persisted(write) == Persisted::kPending &&
                       std::chrono::steady_clock::now() < until;
    return waits && !give_up ? std::nullopt : std::optional<Response>(stopped(context, write));
  }};
}

Outcome handle(Call& call, const protocol::DeviceClaim& request) {
  HandlerContext& context = call.context;
  const model::Tick now = call.device_view().now().tick;
  if (auto refused = claimed(call)) return Response(std::move(*refused));
  context.claim.take(call.session.id, now, request.lease_ms);
  for (Effect* effect : context.effects.playing())
    if (effect->owner != call.session.id)
      request_stop(context, *effect, control::EndReason::kStopped);
  return Response(protocol::ClaimResult{request.lease_ms});
}

Outcome handle(Call& call, const protocol::DeviceRelease&) {
  call.context.claim.release(call.session.id);
  return Response(protocol::Done{});
}

}  // namespace hedgehog::server
