// SPDX-License-Identifier: MIT
#include "daemon/server/effects/planning.h"

#include <utility>

#include "daemon/server/disk/pattern_library.h"

namespace hedgehog::server {
namespace {

using protocol::EffectParams;

SpecFacts spec_facts(const PlanContext& context) {
  const DeviceView& m = context.device_view;
  return {m.limits(),   m.config().device.force_slope_n_a,
          m.array(),    m.pin_pitch_deg(),
          context.role, m.epoch_ns(),
          m.now().tick};
}

Wave wave_of(const EffectParams& params) {
  return {params.waveform, params.frequency_hz, params.on_fraction};
}

void set_wave(EffectParams& params, const Wave& wave) {
  params.waveform = wave.waveform;
  params.frequency_hz = wave.frequency_hz;
  params.on_fraction = wave.on_fraction;
}

Wave first_set(const Wave& wave, const Wave& otherwise) {
  return {wave.waveform ? wave.waveform : otherwise.waveform,
          wave.frequency_hz ? wave.frequency_hz : otherwise.frequency_hz,
          wave.on_fraction ? wave.on_fraction : otherwise.on_fraction};
}

/// The key frames requested by `params`; nullptr: none. Waveform fields of the pattern are copied
/// to `params` where the client has set none.
protocol::Result<KeyframeTrackPtr> take_keyframes(const PlanContext& context,
                                                  EffectParams& params) {
  const model::PinArray& pins = context.device_view.array();
  if (params.keyframes) {
    auto track = make_keyframe_track(*params.keyframes, pins);
    params.keyframes.reset();
    return track;
  }
  if (!params.pattern) return KeyframeTrackPtr();
  const PatternLibrary& patterns = context.patterns;
  const PatternLibrary::Entry* entry = patterns.find(*params.pattern);
  if (entry == nullptr)
    return protocol::no_such_pattern("pattern", *params.pattern, patterns.names());
  const protocol::Pattern& pattern = entry->pattern;
  set_wave(params, first_set(wave_of(params),
                             {pattern.waveform, pattern.frequency_hz, pattern.on_fraction}));
  return make_keyframe_track(pattern.keyframes, pins);
}

}  // namespace

protocol::Result<EffectPlan> plan_start(const PlanContext& context,
                                        const protocol::EffectStart& request) {
  EffectPlan plan;
  plan.params = request.params;
  plan.requested_wave = wave_of(request.params);
  auto track = take_keyframes(context, plan.params);
  if (track.has_error()) return track.error();
  plan.track = std::move(*track);
  plan.params = protocol::with_defaults(request.method, std::move(plan.params));
  auto spec = make_spec(request.method, plan.params, spec_facts(context), plan.track.get());
  if (spec.has_error()) return spec.error();
  plan.spec = *spec;
  return plan;
}

std::optional<protocol::RpcError> no_orientation(const DeviceView& device_view,
                                                 const model::EffectSpec& spec) {
  if (spec.frame != model::Frame::kWorld || device_view.orientation_known()) return std::nullopt;
  protocol::RpcError e = protocol::device_absent(
      "frame", "world needs an orientation sensor, and none is connected", "imu");
  e.value = std::string("world");
  return e;
}

protocol::Result<EffectPlan> plan_update(const PlanContext& context, const EffectPlan& before,
                                         const EffectParams& update) {
  const model::EffectMethod method = before.spec.method;
  EffectPlan plan;
  auto params = merged(method, before.params, update);
  if (params.has_error()) return params.error();
  plan.requested_wave = first_set(wave_of(update), before.requested_wave);
  EffectParams fresh = update;
  set_wave(fresh, plan.requested_wave);
  auto track = take_keyframes(context, fresh);
  if (track.has_error()) return track.error();
  plan.track = *track != nullptr ? *track : before.track;
  plan.params = std::move(*params);
  if (*track != nullptr) {
    // No waveform field of the previous pattern is kept.
    set_wave(plan.params, wave_of(fresh));
    plan.params = protocol::with_defaults(method, std::move(plan.params));
  }
  auto spec = make_spec(method, plan.params, spec_facts(context), plan.track.get());
  if (spec.has_error()) return spec.error();
  plan.spec = *spec;
  plan.spec.trajectory.playback.first = before.spec.trajectory.playback.first;
  return plan;
}

}  // namespace hedgehog::server
