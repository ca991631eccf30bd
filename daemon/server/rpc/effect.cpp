// SPDX-License-Identifier: MIT
// effect.pulse, .circle, .vibrate, .hold, .play, .update, .stop, .stop_all
#include <string>
#include <utility>

#include "daemon/server/effects/admission.h"
#include "daemon/server/effects/planning.h"
#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {

namespace {

using protocol::RpcError;

std::optional<RpcError> no_capacity(const Call& call, bool replacing) {
  switch (call.context.effects.capacity(call.session.id, replacing)) {
    case EffectRegistry::Capacity::kYes:
      return std::nullopt;
    case EffectRegistry::Capacity::kConnectionFull: {
      RpcError e = protocol::busy("you play 32 effects already; stop one first", 1);
      e.field = "effects";
      e.limit = std::int64_t{EffectRegistry::kMaxEach};
      return e;
    }
    case EffectRegistry::Capacity::kDeviceFull: {
      RpcError e = protocol::busy("the ball plays 64 effects already", 1);
      e.field = "effects";
      e.limit = std::int64_t{control::kMaxEffects};
      return e;
    }
    case EffectRegistry::Capacity::kPlacesFull:
      break;
  }
  return protocol::busy("the entries of ended effects are not released yet", 1);
}

/// Checks all reasons against playing `plan`, which replaces or updates `before` (nullptr:
/// neither). What only the response needs is not computed for a notification.
protocol::Result<Delivery> admit(const Call& call, const EffectPlan& plan, const Effect* before) {
  const DeviceView& device_view = call.device_view();
  const auto& [params, requested_wave, spec, track] = plan;
  if (auto refused = no_orientation(device_view, spec)) return std::move(*refused);
  const bool may_refuse = params.if_limited == protocol::IfLimited::kRefuse;
  if (!call.expects_response && !may_refuse) return Delivery{};
  Delivery delivery =
      expected_delivery(device_view, call.context.effects, spec, track.get(), before);
  if (!may_refuse) return delivery;
  const protocol::Admission admitted = with_headroom(device_view, std::move(delivery));
  if (auto refused = thermal_refusal(device_view, spec, track.get(), params, admitted))
    return std::move(*refused);
  return Delivery{admitted, std::nullopt};
}

/// Queues the key frames of `plan`. Afterwards there is capacity for one more command, so that the
/// start cannot be rejected after its key frames.
std::optional<RpcError> place_keyframes(const Call& call, EffectPlan& plan) {
  if (!plan.track) return std::nullopt;
  Outbox& outbox = call.device_view().outbox();
  KeyframeAllocator& keyframes = call.context.keyframes;
  const std::size_t commands = keyframes.commands_for(*plan.track) + 1;
  if (!outbox.has_capacity(call.session.id, commands)) return queue_full(outbox, commands);
  const auto full = [&](const char* what, std::int64_t limit) {
    RpcError e = protocol::busy(what, 10);
    e.field = plan.params.pattern ? "pattern" : "keyframes";
    e.limit = limit;
    return e;
  };
  if (!keyframes.within_share(*plan.track, call.session.id)) {
    return full("the effects of this connection would exceed its limit of 1024 key frames",
                KeyframeAllocator::kShare);
  }
  const auto first = keyframes.place(*plan.track, call.session.id, outbox);
  if (!first) return full("the pool of 2048 key frames is full", control::kKeyframeCapacity);
  plan.spec.trajectory.playback.first = *first;
  return std::nullopt;
}

/// `plan` needs no key frames but those of `before`.
bool same_keyframes(const Call& call, const EffectPlan& before, const EffectPlan& plan) {
  if (plan.track == nullptr || before.track == nullptr) return plan.track == before.track;
  return call.context.keyframes.holds(before.spec.trajectory.playback.first, *plan.track);
}

/// Replaces the still queued start of `before` by that of `plan`, under the same number. False if
/// it has been passed on, or if `plan` has other key frames, which would be queued after it.
bool coalesce(const Call& call, const Effect& before, EffectPlan& plan) {
  if (!same_keyframes(call, before.plan, plan)) return false;
  plan.spec.trajectory.playback.first = before.plan.spec.trajectory.playback.first;
  return call.device_view().outbox().amend(before.id, plan.spec);
}

Outcome response_of(const Call& call, Delivery delivery, const Effect& effect, std::uint64_t seq) {
  delivery.admission.effect = effect.id;
  delivery.admission.slot = effect.slot;
  delivery.admission.seq = seq;
  if (!delivery.forecast_of) return Response(std::move(delivery.admission));
  return AfterCommit{[&device_view = call.device_view(), delivery = std::move(delivery)] {
    return Response(with_headroom(device_view, delivery));
  }};
}

Effect* addressed(const Call& call, const std::optional<protocol::EffectNumber>& number,
                  const std::optional<std::string>& slot) {
  EffectRegistry& effects = call.context.effects;
  return number ? effects.find(call.session.id, *number)
                : effects.find(call.session.id, slot.value_or(""));
}

RpcError not_found(const std::optional<protocol::EffectNumber>& number,
                   const std::optional<std::string>& slot) {
  return number ? protocol::no_such_effect(*number) : protocol::no_such_slot(slot.value_or(""));
}

}  // namespace

Outcome handle(Call& call, const protocol::EffectStart& request) {
  HandlerContext& context = call.context;
  if (auto refused = not_playable(call.device_view())) return Response(std::move(*refused));
  if (auto refused = claimed(call)) return Response(std::move(*refused));
  auto plan = plan_start(call.plan_context(), request);
  if (plan.has_error()) return Response(plan.error());
  const std::optional<std::string>& slot = plan->params.slot;
  Effect* before = slot ? context.effects.find(call.session.id, *slot) : nullptr;
  const bool waits = before != nullptr && context.device_view.outbox().holds(before->seq);
  auto full = no_capacity(call, before != nullptr);
  if (full && !waits) return Response(std::move(*full));
  auto delivery = admit(call, *plan, before);
  if (delivery.has_error()) return Response(delivery.error());
  if (waits && coalesce(call, *before, *plan)) {
    before->plan = *std::move(plan);
    return response_of(call, *std::move(delivery), *before, before->seq);
  }
  if (full) return Response(std::move(*full));
  // One start per tick is enough for a slot; later ones with the same key frames amend it.
  const bool in_turn = before != nullptr && same_keyframes(call, before->plan, *plan);
  if (auto refused = place_keyframes(call, *plan)) return Response(std::move(*refused));

  Effect& effect = context.effects.add(call.session.id);
  control::StartEffect start{effect.id, effect.place, 0, 0, plan->spec};
  if (before != nullptr) {
    start.replaces = before->id;
    start.replaces_place = before->place;
  }
  const auto seq =
      context.device_view.outbox().add(call.session.id, start, in_turn ? before->seq : 0);
  if (!seq) {
    context.effects.drop(effect);
    return Response(queue_full(call.device_view().outbox()));
  }
  if (before != nullptr) before->ending = true;
  effect.replacing = before != nullptr;
  effect.client = call.session.client;
  effect.slot = slot;
  effect.plan = *std::move(plan);
  effect.seq = *seq;
  return response_of(call, *std::move(delivery), effect, *seq);
}

Outcome handle(Call& call, const protocol::EffectUpdate& request) {
  Effect* effect = addressed(call, request.effect, request.params.slot);
  if (effect == nullptr) return Response(not_found(request.effect, request.params.slot));
  if (auto refused = claimed(call)) return Response(std::move(*refused));
  const bool onset_moved = request.params.delay_ms || request.params.start_at_ns;
  if (onset_moved && effect->begun) {
    return Response(protocol::invalid_params(request.params.delay_ms ? "delay_ms" : "start_at_ns",
                                             "this effect has begun already"));
  }
  auto plan = plan_update(call.plan_context(), effect->plan, request.params);
  if (plan.has_error()) return Response(plan.error());
  auto delivery = admit(call, *plan, effect);
  if (delivery.has_error()) return Response(delivery.error());
  const bool other_frames = plan->track != effect->plan.track;
  if (other_frames) {
    if (auto refused = place_keyframes(call, *plan)) return Response(std::move(*refused));
  }
  const auto seq = call.device_view().outbox().add(
      call.session.id, control::UpdateEffect{effect->id, effect->place, plan->spec});
  if (!seq) return Response(queue_full(call.device_view().outbox()));
  if (other_frames)
    call.context.keyframes.release_after(effect->plan.spec.trajectory.playback.first, *seq);
  effect->plan = *std::move(plan);
  return response_of(call, *std::move(delivery), *effect, *seq);
}

Outcome handle(Call& call, const protocol::EffectStop& request) {
  Effect* effect = addressed(call, request.effect, request.slot);
  if (effect == nullptr) return Response(not_found(request.effect, request.slot));
  request_stop(call.context, *effect, control::EndReason::kStopped);
  return Response(protocol::StopResult{1, call.device_view().outbox().last_seq()});
}

Outcome handle(Call& call, const protocol::EffectStopAll& request) {
  const bool all = request.scope == protocol::Scope::kAll;
  if (all && call.session.role < protocol::Role::kOperate) {
    RpcError e = protocol::forbidden("scope", "all", protocol::Role::kOperate, call.session.role);
    e.value = std::string("all");
    return Response(std::move(e));
  }
  std::int64_t stopped = 0;
  for (Effect* effect : call.context.effects.playing(all ? 0 : call.session.id)) {
    request_stop(call.context, *effect, control::EndReason::kStopped);
    ++stopped;
  }
  return Response(protocol::StopResult{stopped, call.device_view().outbox().last_seq()});
}

}  // namespace hedgehog::server
