// SPDX-License-Identifier: MIT
// effect.pulse, .circle, .vibrate, .hold, .play, .update, .stop, .stop_all
#include <string>
#include <utility>

#include "daemon/server/admission.h"
#include "daemon/server/effect_plan.h"
#include "daemon/server/handlers.h"

namespace hedgehog::server {

namespace {

using protocol::RpcError;

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

/// Everything that can speak against playing `plan`, which replaces or updates `before` (nullptr:
/// neither). The admission is only worked out when somebody asks for it.
protocol::Result<protocol::Admission> admit(const Call& call, const EffectPlan& plan,
                                            const Effect* before) {
  const Machine& machine = call.machine();
  const auto& [params, said_wave, spec, score] = plan;
  if (auto refused = no_orientation(machine, spec)) {
    return std::move(*refused);
  }
  const bool may_refuse = params.if_limited == protocol::IfLimited::kRefuse;
  if (!call.answered && !may_refuse) {
    return protocol::Admission{};
  }
  const protocol::Admission admitted =
      admission(machine, call.services.effects, spec, score.get(), before);
  if (may_refuse) {
    if (auto refused = thermal_refusal(machine, spec, score.get(), params, admitted)) {
      return std::move(*refused);
    }
  }
  return admitted;
}

/// Hands the key frames of `plan` over. Afterwards there is room for one more command, so that what
/// plays them cannot be refused and leave them behind.
std::optional<RpcError> place_keyframes(const Call& call, EffectPlan& plan) {
  if (!plan.score) {
    return std::nullopt;
  }
  Outbox& outbox = call.machine().outbox();
  KeyframeRoom& keyframes = call.services.keyframes;
  const std::size_t commands = keyframes.commands_for(*plan.score) + 1;
  if (!outbox.room(call.session.id, commands)) {
    return queue_full(outbox, commands);
  }
  const auto full = [&](const char* what, std::int64_t limit) {
    RpcError e = protocol::busy(what, 10);
    e.field = plan.params.pattern ? "pattern" : "keyframes";
    e.limit = limit;
    return e;
  };
  if (!keyframes.within_share(*plan.score, call.session.id)) {
    return full("this connection's effects play 1024 key frames already, as many as one may",
                KeyframeRoom::kShare);
  }
  const auto first = keyframes.place(*plan.score, call.session.id, outbox);
  if (!first) {
    return full("the key frames of all effects fill their room of 2048", control::kKeyframeRoom);
  }
  plan.spec.trajectory.score.first = *first;
  return std::nullopt;
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
  auto plan = plan_start(call, request);
  if (plan.has_error()) {
    return Answer(plan.error());
  }
  const std::optional<std::string>& slot = plan->params.slot;
  Effect* before = slot ? services.effects.find(call.session.id, *slot) : nullptr;
  if (auto refused = no_room(call, before != nullptr)) {
    return Answer(std::move(*refused));
  }
  auto admitted = admit(call, *plan, before);
  if (admitted.has_error()) {
    return Answer(admitted.error());
  }
  if (auto refused = place_keyframes(call, *plan)) {
    return Answer(std::move(*refused));
  }

  Effect& effect = services.effects.add(call.session.id);
  control::StartEffect start{effect.id, effect.place, 0, 0, plan->spec};
  if (before != nullptr) {
    start.replaces = before->id;
    start.replaces_place = before->place;
  }
  const auto seq = services.machine.outbox().add(call.session.id, start);
  if (!seq) {
    services.effects.drop(effect);
    return Answer(queue_full(call.machine().outbox()));
  }
  if (before != nullptr) {
    before->ending = true;
  }
  effect.replacing = before != nullptr;
  effect.client = call.session.client;
  effect.slot = slot;
  effect.method = request.method;
  effect.params = std::move(plan->params);
  effect.said_wave = plan->said_wave;
  effect.spec = plan->spec;
  effect.score = std::move(plan->score);
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
  auto plan = plan_update(call, *effect, request.params);
  if (plan.has_error()) {
    return Answer(plan.error());
  }
  auto admitted = admit(call, *plan, effect);
  if (admitted.has_error()) {
    return Answer(admitted.error());
  }
  const bool other_frames = plan->score != effect->score;
  if (other_frames) {
    if (auto refused = place_keyframes(call, *plan)) {
      return Answer(std::move(*refused));
    }
  }
  const auto seq = call.machine().outbox().add(
      call.session.id, control::UpdateEffect{effect->id, effect->place, plan->spec});
  if (!seq) {
    return Answer(queue_full(call.machine().outbox()));
  }
  if (other_frames) {
    call.services.keyframes.let_go_after(effect->spec.trajectory.score.first, *seq);
  }
  effect->params = std::move(plan->params);
  effect->said_wave = plan->said_wave;
  effect->spec = plan->spec;
  effect->score = std::move(plan->score);
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
