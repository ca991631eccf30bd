// SPDX-License-Identifier: MIT
// effect.pulse, .circle, .vibrate, .hold, .update, .stop, .stop_all
#include <string>
#include <utility>

#include "daemon/server/admission.h"
#include "daemon/server/effect_spec.h"
#include "daemon/server/handlers.h"

namespace hedgehog::server {

SpecFacts spec_facts(const Call& call) {
  const Machine& m = call.services.machine;
  return {m.limits(),   m.config().device.force_slope_n_a,
          m.array(),    call.session.role,
          m.epoch_ns(), m.now().tick};
}

namespace {

using protocol::RpcError;

std::optional<RpcError> claimed(const Call& call) {
  const model::Tick now = call.machine().now().tick;
  if (!call.services.claim.excludes(call.session.id, now)) {
    return std::nullopt;
  }
  RpcError e = protocol::error(protocol::ErrorCode::kClaimed,
                               "claimed: another client has the ball for itself");
  e.retry_after_ms = call.services.claim.remaining(now);
  return e;
}

std::optional<RpcError> no_room(const Call& call, bool replacing) {
  switch (call.services.effects.room(call.session.id, replacing)) {
    case EffectRegistry::Room::kYes:
      return std::nullopt;
    case EffectRegistry::Room::kConnectionFull: {
      RpcError e = protocol::busy("you play 32 effects already; stop one first", 1);
      e.field = "effects";
      e.limit = std::int64_t{EffectRegistry::kMaxEach};
      return e;
    }
    case EffectRegistry::Room::kDeviceFull: {
      RpcError e = protocol::busy("the ball plays 64 effects already", 1);
      e.field = "effects";
      e.limit = std::int64_t{control::kMaxEffects};
      return e;
    }
    case EffectRegistry::Room::kPlacesFull:
      break;
  }
  return protocol::busy("effects that have just ended still hold their places", 1);
}

/// Everything that can speak against playing `spec`, which replaces or updates `before` (nullptr:
/// neither). The admission is only worked out when somebody asks for it.
protocol::Result<protocol::Admission> admit(const Call& call, const model::EffectSpec& spec,
                                            const protocol::EffectParams& params,
                                            const Effect* before) {
  const Machine& machine = call.machine();
  if (spec.frame == model::Frame::kWorld && !machine.orientation_known()) {
    RpcError e = protocol::device_absent(
        "frame", "world needs an orientation sensor, and none is connected", "imu");
    e.value = std::string("world");
    return e;
  }
  const bool may_refuse = params.if_limited == protocol::IfLimited::kRefuse;
  if (!call.answered && !may_refuse) {
    return protocol::Admission{};
  }
  const protocol::Admission admitted = admission(machine, call.services.effects, spec, before);
  if (may_refuse) {
    if (auto refused = thermal_refusal(machine, spec, params, admitted)) {
      return std::move(*refused);
    }
  }
  return admitted;
}

void request_stop(Services& services, Effect& effect, control::EndReason reason) {
  services.machine.mailbox().stops.request(effect.id, effect.place, reason);
  effect.ending = true;
}

Effect* addressed(const Call& call, const std::optional<protocol::EffectNumber>& number,
                  const std::optional<std::string>& slot) {
  EffectRegistry& effects = call.services.effects;
  return number ? effects.find(call.session.id, *number)
                : effects.find(call.session.id, slot.value_or(""));
}

RpcError not_found(const std::optional<protocol::EffectNumber>& number,
                   const std::optional<std::string>& slot) {
  return number ? protocol::no_such_effect(*number) : protocol::no_such_slot(slot.value_or(""));
}

}  // namespace

Outcome effect_start(Call& call, const protocol::EffectStart& request) {
  Services& services = call.services;
  if (auto refused = not_playable(call.machine())) {
    return Answer(std::move(*refused));
  }
  if (auto refused = claimed(call)) {
    return Answer(std::move(*refused));
  }
  const protocol::EffectParams params = protocol::with_defaults(request.method, request.params);
  const model::EffectMethod method = protocol::effect_of(request.method).value();
  const auto spec = make_spec(method, params, spec_facts(call));
  if (spec.has_error()) {
    return Answer(spec.error());
  }
  Effect* before = params.slot ? services.effects.find(call.session.id, *params.slot) : nullptr;
  if (auto refused = no_room(call, before != nullptr)) {
    return Answer(std::move(*refused));
  }
  auto admitted = admit(call, *spec, params, before);
  if (admitted.has_error()) {
    return Answer(admitted.error());
  }

  Effect& effect = services.effects.add(call.session.id);
  control::StartEffect start{effect.id, effect.place, 0, 0, *spec};
  if (before != nullptr) {
    start.replaces = before->id;
    start.replaces_place = before->place;
  }
  const auto seq = services.machine.outbox().add(call.session.id, start);
  if (!seq) {
    services.effects.drop(effect);
    return Answer(queue_full());
  }
  if (before != nullptr) {
    before->ending = true;
  }
  effect.client = call.session.client;
  effect.slot = params.slot;
  effect.method = request.method;
  effect.params = params;
  effect.spec = *spec;
  effect.seq = *seq;

  admitted->effect = effect.id;
  admitted->slot = effect.slot;
  admitted->seq = *seq;
  return Answer(*admitted);
}

Outcome effect_update(Call& call, const protocol::EffectUpdate& request) {
  Effect* effect = addressed(call, request.effect, request.params.slot);
  if (effect == nullptr) {
    return Answer(not_found(request.effect, request.params.slot));
  }
  if (auto refused = claimed(call)) {
    return Answer(std::move(*refused));
  }
  const bool onset_moved = request.params.delay_ms || request.params.start_at_ns;
  if (onset_moved && effect->begun) {
    return Answer(protocol::invalid_params(request.params.delay_ms ? "delay_ms" : "start_at_ns",
                                           "this effect has begun already"));
  }
  const auto params = merged(effect->spec.method, effect->params, request.params);
  if (params.has_error()) {
    return Answer(params.error());
  }
  const auto spec = make_spec(effect->spec.method, *params, spec_facts(call));
  if (spec.has_error()) {
    return Answer(spec.error());
  }
  auto admitted = admit(call, *spec, *params, effect);
  if (admitted.has_error()) {
    return Answer(admitted.error());
  }
  const auto seq = call.machine().outbox().add(
      call.session.id, control::UpdateEffect{effect->id, effect->place, *spec});
  if (!seq) {
    return Answer(queue_full());
  }
  effect->params = *params;
  effect->spec = *spec;
  admitted->effect = effect->id;
  admitted->slot = effect->slot;
  admitted->seq = *seq;
  return Answer(*admitted);
}

Outcome effect_stop(Call& call, const protocol::EffectStop& request) {
  Effect* effect = addressed(call, request.effect, request.slot);
  if (effect == nullptr) {
    return Answer(not_found(request.effect, request.slot));
  }
  request_stop(call.services, *effect, control::EndReason::kStopped);
  return Answer(protocol::StopResult{1, call.machine().outbox().last_seq()});
}

Outcome effect_stop_all(Call& call, const protocol::EffectStopAll& request) {
  const bool all = request.scope == protocol::Scope::kAll;
  if (all && call.session.role < protocol::Role::kOperate) {
    RpcError e = protocol::forbidden("scope", "all", protocol::Role::kOperate, call.session.role);
    e.value = std::string("all");
    return Answer(std::move(e));
  }
  std::int64_t stopped = 0;
  for (Effect* effect : call.services.effects.playing(all ? 0 : call.session.id)) {
    request_stop(call.services, *effect, control::EndReason::kStopped);
    ++stopped;
  }
  return Answer(protocol::StopResult{stopped, call.machine().outbox().last_seq()});
}

}  // namespace hedgehog::server
