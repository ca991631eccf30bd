// SPDX-License-Identifier: MIT
#include "clients/gamepad/effect_player.h"

#include <algorithm>
#include <cerrno>
#include <utility>

namespace hedgehog::gamepad {

namespace {

constexpr double kFullGain = 0xffff;

}  // namespace

EffectPlayer::Effect* EffectPlayer::find(std::int64_t id) {
  if (id < 0 || id >= kMaxEffects) return nullptr;
  Effect& effect = effects_[static_cast<std::size_t>(id)];
  return effect.uploaded ? &effect : nullptr;
}

std::string EffectPlayer::slot(const Effect& effect, const std::array<Effect, kMaxEffects>& all) {
  return "ff" + std::to_string(&effect - all.data());
}

bool EffectPlayer::is_playing(std::int64_t id) const {
  return id >= 0 && id < kMaxEffects && effects_[static_cast<std::size_t>(id)].repetitions > 0;
}

int EffectPlayer::upload(const ff_effect& effect, TimePoint now) {
  if (!can_translate(effect) || effect.id < 0 || effect.id >= kMaxEffects) return EINVAL;
  Effect& place = effects_[static_cast<std::size_t>(effect.id)];
  place.uploaded = effect;
  place.translated = translate(effect, options_);
  if (place.repetitions == 0) return 0;
  place.stop_at = now + kMaxPlay;
  // A new effect in the slot replaces the old one without a gap; a silent or delayed one does not.
  if (place.started && (!place.translated.start || place.translated.delay.count() > 0))
    requests_.emplace_back(protocol::EffectStop{std::nullopt, slot(place, effects_)});
  schedule(place, now);
  advance(place, now);
  return 0;
}

int EffectPlayer::erase(std::int64_t id, TimePoint now) {
  Effect* effect = find(id);
  if (effect == nullptr) return EINVAL;
  play(id, 0, now);
  effect->uploaded.reset();
  return 0;
}

void EffectPlayer::play(std::int64_t id, std::int32_t count, TimePoint now) {
  Effect* effect = find(id);
  if (effect == nullptr) return;
  if (count <= 0) {
    if (effect->repetitions > 0) stop(*effect);
    return;
  }
  if (effect->started && effect->translated.delay.count() > 0) stop(*effect);
  effect->repetitions = count;
  effect->stop_at = now + kMaxPlay;
  schedule(*effect, now);
  advance(*effect, now);
}

void EffectPlayer::set_gain(std::int32_t gain) {
  gain_ = std::clamp(gain / kFullGain, 0.0, 1.0);
  for (Effect& effect : effects_) {
    if (!effect.started || !effect.translated.start) continue;
    protocol::EffectParams change;
    change.slot = slot(effect, effects_);
    change.gain = gain_;
    requests_.emplace_back(protocol::EffectUpdate{std::nullopt, change});
  }
}

void EffectPlayer::schedule(Effect& effect, TimePoint from) const {
  effect.started = false;
  effect.begins = from + effect.translated.delay;
  effect.ends = effect.begins + effect.translated.length;
}

void EffectPlayer::advance(TimePoint now) {
  for (Effect& effect : effects_)
    if (effect.repetitions > 0) advance(effect, now);
}

void EffectPlayer::advance(Effect& effect, TimePoint now) {
  while (effect.repetitions > 0 && next_step(effect) <= now) {
    if (effect.stop_at <= now) {
      stop(effect);
      return;
    }
    if (!effect.started) {
      // A repetition whose end has passed before its start is left out.
      if (effect.ends <= now) {
        end_repetition(effect, now);
        continue;
      }
      start(effect);
      effect.renew = now + kRenewAfter;
    } else if (effect.ends <= now) {
      end_repetition(effect, now);
    } else {
      protocol::EffectParams renewal;
      renewal.slot = slot(effect, effects_);
      requests_.emplace_back(protocol::EffectUpdate{std::nullopt, renewal});
      effect.renew = now + kRenewAfter;
    }
  }
}

void EffectPlayer::start(Effect& effect) {
  effect.started = true;
  effect.leased = false;
  if (!effect.translated.start) return;
  protocol::EffectStart request = *effect.translated.start;
  request.params.slot = slot(effect, effects_);
  if (gain_ < 1.0) request.params.gain = gain_;
  effect.leased = effect.translated.length.count() > protocol::kMaxDurationMs;
  if (effect.leased)
    request.params.lease_ms = kLease.count();
  else
    request.params.duration_ms = effect.translated.length.count();
  requests_.emplace_back(std::move(request));
}

void EffectPlayer::end_repetition(Effect& effect, TimePoint now) {
  if (effect.repetitions == 1) {
    // An effect with a duration has ended automatically, by the device's clock.
    if (effect.leased) {
      stop(effect);
      return;
    }
    effect.repetitions = 0;
    effect.started = false;
    return;
  }
  if (effect.started && effect.leased && effect.translated.delay.count() > 0)
    requests_.emplace_back(protocol::EffectStop{std::nullopt, slot(effect, effects_)});
  // Repetitions that were missed without a call are not caught up.
  const auto period = effect.translated.delay + effect.translated.length;
  const auto missed = std::max<std::int64_t>(0, (now - effect.ends) / period);
  effect.repetitions -=
      static_cast<std::int32_t>(std::min<std::int64_t>(missed + 1, effect.repetitions - 1));
  schedule(effect, effect.ends + missed * period);
}

void EffectPlayer::stop(Effect& effect) {
  if (effect.started && effect.translated.start)
    requests_.emplace_back(protocol::EffectStop{std::nullopt, slot(effect, effects_)});
  effect.repetitions = 0;
  effect.started = false;
  effect.leased = false;
}

TimePoint EffectPlayer::next_step(const Effect& effect) const {
  TimePoint next = effect.started ? effect.ends : effect.begins;
  if (effect.started && effect.leased) next = std::min(next, effect.renew);
  return std::min(next, effect.stop_at);
}

std::optional<TimePoint> EffectPlayer::deadline() const {
  std::optional<TimePoint> first;
  for (const Effect& effect : effects_) {
    if (effect.repetitions == 0) continue;
    const TimePoint next = next_step(effect);
    if (!first || next < *first) first = next;
  }
  return first;
}

std::vector<protocol::Request> EffectPlayer::take_requests() {
  return std::exchange(requests_, {});
}

void EffectPlayer::on_connect(double felt_level) {
  options_.felt_level = std::min(felt_level, options_.full_level);
  for (Effect& effect : effects_) {
    effect.repetitions = 0;
    effect.started = false;
    effect.leased = false;
    if (effect.uploaded) effect.translated = translate(*effect.uploaded, options_);
  }
  requests_.clear();
}

}  // namespace hedgehog::gamepad
