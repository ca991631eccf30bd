// SPDX-License-Identifier: MIT
#include "daemon/control/effects/effect_place.h"

#include <algorithm>

#include "daemon/control/effects/mixer.h"

namespace hedgehog::control {
namespace {

using model::EffectSpec;
using model::Keyframe;
using model::Path;
using model::Tick;

constexpr Tick kLongest = 10 * model::kTicksPerSecond;

Tick onset_of(const EffectSpec& spec, Tick applied) noexcept {
  return spec.start_at >= 0 ? spec.start_at : applied + spec.delay;
}

}  // namespace

void EffectPlace::begin(EffectId effect, const EffectSpec& spec, Tick now) noexcept {
  *this = EffectPlace{};
  effect_ = effect;
  spec_ = spec;
  ring_ = model::ring_of(spec.trajectory);
  applied_ = now;
  onset_ = std::max(now, onset_of(spec, now));
  lease_end_ = onset_ + spec.lease;
}

void EffectPlace::continue_from(const EffectPlace& previous) noexcept {
  const bool has_phase = previous.playing_ || previous.continues_;
  if (!has_phase || previous.spec_.method != spec_.method ||
      previous.spec_.waveform != spec_.waveform)
    return;
  phase_ = model::carried(previous.spec_, spec_, previous.phase_);
  continues_ = true;
  // A pattern that is started twice plays twice.
  const bool may_go_on =
      spec_.trajectory.path != Path::kKeyframes || spec_.trajectory.playback.loop;
  continues_attack_ = may_go_on && spec_.lease > 0 && previous.spec_.lease > 0;
}

void EffectPlace::update(const EffectSpec& spec, Tick now) noexcept {
  phase_ = model::carried(spec_, spec, phase_);
  spec_ = spec;
  ring_ = model::ring_of(spec.trajectory);
  if (!playing_) onset_ = std::max(now, onset_of(spec, applied_));
  if (playing_ && spec.trajectory.playback.ends_with_pattern) {
    spec_.duration = std::min(
        kLongest, phase_.elapsed + model::ticks_to_end(spec.trajectory.playback, phase_.steps));
  }
  lease_end_ = std::max(now, onset_) + spec.lease;
}

bool EffectPlace::advance(Tick now, Tick ticks, std::span<const Keyframe> frames) noexcept {
  if (!playing_ && now < onset_) return true;
  if (playing_ || continues_) phase_ = model::advanced(spec_, ring_, phase_, ticks);
  if (!playing_) {
    playing_ = true;
    delivery_.onset = now;
    if (!continues_attack_) {
      phase_.elapsed = 0;
      if (spec_.trajectory.path == Path::kKeyframes) phase_.steps = 0.0;
    }
  }
  if (spec_.trajectory.path == Path::kKeyframes) {
    const model::KeyframePlayback& playback = spec_.trajectory.playback;
    const std::size_t first = std::min<std::size_t>(playback.first, frames.size());
    point_ = model::point_at(
        frames.subspan(first, std::min<std::size_t>(playback.count, frames.size() - first)),
        phase_.steps);
    point_.direction = rotate(playback.turn, point_.direction);
  }
  return spec_.duration > 0 ? phase_.elapsed < spec_.duration : now < lease_end_;
}

EndReason EffectPlace::natural_end() const noexcept {
  if (counted_ == 0 && delivery_.masked > 0) return EndReason::kPreempted;
  return spec_.duration > 0 ? EndReason::kCompleted : EndReason::kExpired;
}

bool EffectPlace::finishes_on_close() const noexcept {
  return spec_.finish_on_close && spec_.duration > 0 && spec_.duration <= Mixer::kLongestFinish;
}

double EffectPlace::requested_a() const noexcept {
  const double shape = spec_.trajectory.path == Path::kKeyframes ? point_.level : 1.0;
  return spec_.strength_a * spec_.gain * shape * model::level_at(spec_, phase_);
}

model::Vec3 EffectPlace::direction() const noexcept {
  return spec_.trajectory.path == Path::kKeyframes ? point_.direction
                                                   : model::direction_at(ring_, phase_);
}

void EffectPlace::note_delivered(double fraction, bool mixed) noexcept {
  delivery_.min = std::min(delivery_.min, fraction);
  delivered_sum_ += fraction;
  ++counted_;
  if (mixed) ++delivery_.mixed;
}

Delivery EffectPlace::delivery(Tick now) const noexcept {
  Delivery result = delivery_;
  result.offset = now;
  if (counted_ == 0) {
    result.min = 0.0;
    result.mean = 0.0;
  } else {
    result.mean = delivered_sum_ / static_cast<double>(counted_);
  }
  return result;
}

Tick EffectPlace::remaining(Tick now) const noexcept {
  if (spec_.duration <= 0) return std::max<Tick>(0, lease_end_ - now);
  if (!playing_) return std::max<Tick>(0, onset_ - now) + spec_.duration;
  return std::max<Tick>(0, spec_.duration - phase_.elapsed);
}

}  // namespace hedgehog::control
