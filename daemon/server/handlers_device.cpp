// SPDX-License-Identifier: MIT
// device.*, output.set_gain
#include <string>
#include <utility>

#include "daemon/server/handlers.h"

namespace hedgehog::server {
namespace {

/// The board has 300 ticks to answer an arm request (control::StateMachine::kArmPatience).
constexpr model::Tick kArmPatience = 400;

protocol::StateResult state_result(const Machine& machine, std::uint64_t seq) {
  const control::StatusSnapshot& now = machine.now();
  return {std::string(control::name(now.state)), reason_name(now.reason), machine.remedy_now(),
          seq};
}

/// The coils are off and no tick comes any more: the latch is for the next start, as
/// control::StateMachine::emergency_stop would have it.
protocol::StateResult stopped_while_leaving(Machine& machine) {
  const control::StatusSnapshot& now = machine.now();
  protocol::StateResult result = state_result(machine, machine.outbox().last_seq());
  if (now.state == control::State::kArmed || now.state == control::State::kDisarmed) {
    const control::Reason latch =
        now.latch != control::Reason::kNone ? now.latch : control::Reason::kEmergencyStop;
    result.state = control::name(control::State::kDisarmed);
    result.reason = reason_name(latch);
    result.remedy = remedy(control::State::kDisarmed, latch, machine.remedy_facts());
  }
  return result;
}

protocol::RpcError arm_refused(const Machine& machine) {
  const control::StatusSnapshot& now = machine.now();
  const control::Reason why =
      now.arm_refusal != control::Reason::kNone ? now.arm_refusal : now.reason;
  return protocol::not_armed(
      control::name(now.state), control::name(why),
      remedy(control::State::kTripped, why, machine.remedy_facts()).value_or(""));
}

}  // namespace

Outcome device_describe(Call& call, const protocol::DeviceDescribe&) {
  const Machine& machine = call.machine();
  const config::Config& config = machine.config();
  const model::DeviceModel& device = config.device;
  const model::Limits& l = machine.limits();
  protocol::Description d;
  d.name = device.name;
  d.model = device.model;
  d.simulated = machine.simulated();
  d.arrangement = machine.array().arrangement;
  for (const model::Pin& pin : machine.array().pins) {
    const double rest_mm = machine.pin_curves().rest_mm(static_cast<std::size_t>(pin.id));
    d.pins.push_back({pin.id, pin.position, pin.ring, rest_mm});
  }
  for (std::size_t row = 0; row < d.coils.matrix.size(); ++row) {
    d.coils.matrix[row] = device.coils.matrix.row[row];
  }
  d.coils.r25_ohm = device.coils.r25_ohm;
  d.coils.inductance_h = device.coils.inductance_h;
  d.coils.supply_v = device.coils.supply_v;
  d.limits = {l.current_a, l.continuous_a, l.felt_a, l.derate_from_c,
              l.sustain_c, l.zero_c,       l.trip_c, l.rearm_c};
  d.calibration.force_n_per_a = device.force_slope_n_a;
  d.gain = machine.gain();
  d.board.backend = d.simulated ? "simulator" : "usb";
  d.board.present = machine.now().board_present;
  BoardSeen board = machine.board();
  d.board.serial = std::move(board.serial);
  d.board.firmware = std::move(board.firmware);
  d.imu.type = config::name(config.imu);
  d.imu.present = machine.now().orientation_present;
  return Answer(std::move(d));
}

Outcome device_list(Call& call, const protocol::DeviceList&) {
  DeviceLooker* devices = call.services.devices;
  if (devices == nullptr) {
    return Answer(protocol::DevicesResult{});
  }
  const DeviceLooker::Ready ready = devices->look();
  const protocol::RpcError slow = protocol::busy("looking for devices takes too long", 1000);
  if (!ready) {
    return Answer(slow);
  }
  return Deferred{[ready, slow](Services&, bool give_up) -> std::optional<Answer> {
    if (auto found = ready()) {
      return Answer(*std::move(found));
    }
    return give_up ? std::optional<Answer>(slow) : std::nullopt;
  }};
}

Outcome device_status(Call& call, const protocol::DeviceStatus&) {
  return Answer(call.services.status.status(false));
}

Outcome device_arm(Call& call, const protocol::DeviceArm&) {
  Machine& machine = call.machine();
  if (machine.now().state == control::State::kArmed) {
    return Answer(state_result(machine, machine.outbox().last_seq()));
  }
  if (machine.now().state == control::State::kAbsent) {
    return Answer(*not_playable(machine));
  }
  const auto seq = machine.outbox().add(
      call.session.id,
      control::Arm{machine.mailbox().emergency_generation.load(std::memory_order_acquire)});
  if (!seq) {
    return Answer(queue_full(machine.outbox()));
  }
  return Deferred{[seq = *seq, since = model::Tick{-1}](
                      Services& services, bool give_up) mutable -> std::optional<Answer> {
    const control::StatusSnapshot& now = services.machine.now();
    const bool applied = now.applied_seq >= seq;
    if (applied && now.state == control::State::kArmed) {
      return Answer(state_result(services.machine, seq));
    }
    if (give_up) {
      return Answer(control_stuck());
    }
    if (!applied) {
      return std::nullopt;
    }
    since = since < 0 ? now.tick : since;
    const bool refused = now.arm_refusal != control::Reason::kNone;
    if (!refused && now.tick - since < kArmPatience) {
      return std::nullopt;
    }
    return Answer(arm_refused(services.machine));
  }};
}

Outcome device_emergency_stop(Call& call, const protocol::DeviceEmergencyStop&) {
  Machine& machine = call.machine();
  machine.mailbox().emergency_generation.fetch_add(1, std::memory_order_acq_rel);
  call.services.memory.remember_latch(control::Reason::kEmergencyStop);
  if (call.services.leaving) {
    return Answer(stopped_while_leaving(machine));
  }
  // The snapshot may already be a tick older than the request.
  const model::Tick seen = machine.now().tick + 2;
  return Deferred{[seen](Services& services, bool give_up) -> std::optional<Answer> {
    const control::StatusSnapshot& now = services.machine.now();
    if (now.tick >= seen && now.state != control::State::kArmed) {
      return Answer(state_result(services.machine, services.machine.outbox().last_seq()));
    }
    return give_up ? std::optional<Answer>(control_stuck()) : std::nullopt;
  }};
}

Outcome device_claim(Call& call, const protocol::DeviceClaim& request) {
  Services& services = call.services;
  const model::Tick now = call.machine().now().tick;
  if (auto refused = claimed(call)) {
    return Answer(std::move(*refused));
  }
  services.claim.take(call.session.id, now, request.lease_ms);
  for (Effect* effect : services.effects.playing()) {
    if (effect->owner != call.session.id) {
      request_stop(services, *effect, control::EndReason::kStopped);
    }
  }
  return Answer(protocol::ClaimResult{request.lease_ms});
}

Outcome device_release(Call& call, const protocol::DeviceRelease&) {
  call.services.claim.release(call.session.id);
  return Answer(protocol::Done{});
}

Outcome output_set_gain(Call& call, const protocol::OutputSetGain& request) {
  const auto seq = call.machine().ask_gain(call.session.id, request.gain);
  if (!seq) {
    return Answer(queue_full(call.machine().outbox()));
  }
  call.services.memory.remember_gain(request.gain);
  return Answer(protocol::GainResult{request.gain, *seq});
}

}  // namespace hedgehog::server
