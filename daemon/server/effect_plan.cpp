// SPDX-License-Identifier: MIT
#include "daemon/server/effect_plan.h"

#include <utility>

#include "daemon/server/pattern_library.h"

namespace hedgehog::server {
namespace {

using protocol::EffectParams;

SpecFacts spec_facts(const Call& call) {
  const Machine& m = call.services.machine;
  return {m.limits(),   m.config().device.force_slope_n_a,
          m.array(),    call.session.role,
          m.epoch_ns(), m.now().tick};
}

Wave wave_of(const EffectParams& params) {
  return {params.waveform, params.frequency_hz, params.on_fraction};
}

void set_wave(EffectParams& params, const Wave& wave) {
  params.waveform = wave.waveform;
  params.frequency_hz = wave.frequency_hz;
  params.on_fraction = wave.on_fraction;
}

Wave first_said(const Wave& wave, const Wave& otherwise) {
  return {wave.waveform ? wave.waveform : otherwise.waveform,
          wave.frequency_hz ? wave.frequency_hz : otherwise.frequency_hz,
          wave.on_fraction ? wave.on_fraction : otherwise.on_fraction};
}

/// The key frames that `params` ask for; nullptr: none. What the pattern is felt through goes into
/// `params` where nothing else was said.
protocol::Result<ScorePtr> take_keyframes(const Call& call, EffectParams& params) {
  const model::PinArray& pins = call.machine().array();
  if (params.keyframes) {
    auto score = make_score(*params.keyframes, pins);
    params.keyframes.reset();
    return score;
  }
  if (!params.pattern) {
    return ScorePtr();
  }
  const PatternLibrary& patterns = call.services.patterns;
  const PatternLibrary::Entry* entry = patterns.find(*params.pattern);
  if (entry == nullptr) {
    return protocol::no_such_pattern("pattern", *params.pattern, patterns.names());
  }
  const protocol::Pattern& pattern = entry->pattern;
  set_wave(params, first_said(wave_of(params),
                              {pattern.waveform, pattern.frequency_hz, pattern.on_fraction}));
  return make_score(pattern.keyframes, pins);
}

}  // namespace

protocol::Result<EffectPlan> plan_start(const Call& call, const protocol::EffectStart& request) {
  EffectPlan plan;
  plan.params = request.params;
  plan.said_wave = wave_of(request.params);
  auto score = take_keyframes(call, plan.params);
  if (score.has_error()) {
    return score.error();
  }
  plan.score = std::move(*score);
  plan.params = protocol::with_defaults(request.method, std::move(plan.params));
  auto spec = make_spec(protocol::effect_of(request.method).value(), plan.params, spec_facts(call),
                        plan.score.get());
  if (spec.has_error()) {
    return spec.error();
  }
  plan.spec = *spec;
  return plan;
}

std::optional<protocol::RpcError> no_orientation(const Machine& machine,
                                                 const model::EffectSpec& spec) {
  if (spec.frame != model::Frame::kWorld || machine.orientation_known()) {
    return std::nullopt;
  }
  protocol::RpcError e = protocol::device_absent(
      "frame", "world needs an orientation sensor, and none is connected", "imu");
  e.value = std::string("world");
  return e;
}

protocol::Result<EffectPlan> plan_update(const Call& call, const Effect& effect,
                                         const EffectParams& update) {
  const model::EffectMethod method = effect.spec.method;
  EffectPlan plan;
  auto params = merged(method, effect.params, update);
  if (params.has_error()) {
    return params.error();
  }
  plan.said_wave = first_said(wave_of(update), effect.said_wave);
  EffectParams fresh = update;
  set_wave(fresh, plan.said_wave);
  auto score = take_keyframes(call, fresh);
  if (score.has_error()) {
    return score.error();
  }
  plan.score = *score != nullptr ? *score : effect.score;
  plan.params = std::move(*params);
  if (*score != nullptr) {
    // Nothing of the pattern before it stays.
    set_wave(plan.params, wave_of(fresh));
    plan.params = protocol::with_defaults(protocol::method_of(method), std::move(plan.params));
  }
  auto spec = make_spec(method, plan.params, spec_facts(call), plan.score.get());
  if (spec.has_error()) {
    return spec.error();
  }
  plan.spec = *spec;
  plan.spec.trajectory.score.first = effect.spec.trajectory.score.first;
  return plan;
}

}  // namespace hedgehog::server
