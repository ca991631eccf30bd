// SPDX-License-Identifier: MIT
#include "daemon/control/effects/mixer.h"

#include <algorithm>
#include <bit>

namespace hedgehog::control {
namespace {

using model::Frame;
using model::Tick;
using model::Vec3;

constexpr std::size_t kWordBits = 64;

void set(auto& mask, std::size_t place) noexcept {
  mask[place / kWordBits] |= std::uint64_t{1} << (place % kWordBits);
}
void clear(auto& mask, std::size_t place) noexcept {
  mask[place / kWordBits] &= ~(std::uint64_t{1} << (place % kWordBits));
}
bool has(const auto& mask, std::size_t place) noexcept {
  return (mask[place / kWordBits] >> (place % kWordBits) & 1) != 0;
}

/// Calls `use(place)` for every place in `mask`, which may change meanwhile.
void each(const auto& mask, auto&& use) noexcept {
  for (std::size_t word = 0; word < mask.size(); ++word)
    for (std::uint64_t bits = mask[word]; bits != 0; bits &= bits - 1)
      use(word * kWordBits + static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace

bool Mixer::holds(std::size_t place, EffectId effect) const noexcept {
  return place < kEffectPlaces && has(held_, place) && places_[place].effect() == effect;
}

void Mixer::end(std::size_t place, EndReason reason, Tick now, EventList& events) noexcept {
  Event event;
  event.type = EventType::kEffectEnded;
  event.end_reason = reason;
  event.place = static_cast<std::uint8_t>(place);
  event.effect = places_[place].effect();
  event.tick = now;
  event.delivery = places_[place].delivery(now);
  events.push(event);
  clear(held_, place);
  clear(active_, place);
  clear(received_, place);
}

void Mixer::load(const LoadKeyframes& command) noexcept {
  const std::size_t count = std::min<std::size_t>(command.count, LoadKeyframes::kMaxFrames);
  if (command.first + count > frames_.size()) return;
  std::copy_n(command.frames.begin(), count, frames_.begin() + command.first);
}

void Mixer::start(const StartEffect& command, std::uint64_t seq, Tick now,
                  EventList& events) noexcept {
  const std::size_t place = command.place;
  if (place >= kEffectPlaces || command.effect == 0) return;
  EffectPlace effect;
  effect.begin(command.effect, command.spec, now);
  if (command.replaces != 0 && holds(command.replaces_place, command.replaces)) {
    effect.continue_from(places_[command.replaces_place]);
    end(command.replaces_place, EndReason::kReplaced, now, events);
  }
  if (has(held_, place)) end(place, EndReason::kReplaced, now, events);
  places_[place] = effect;
  parts_[place] = {};
  set(held_, place);

  Event event;
  event.type = EventType::kEffectStarted;
  event.place = command.place;
  event.effect = command.effect;
  event.seq = seq;
  event.tick = now;
  events.push(event);

  const PendingStop pending = pending_[place];
  if (pending.effect == command.effect) {
    pending_[place] = {};
    stop({command.effect, command.place, pending.reason}, now, events);
  }
}

void Mixer::update(const UpdateEffect& command, Tick now) noexcept {
  if (holds(command.place, command.effect)) places_[command.place].update(command.spec, now);
}

void Mixer::stop(const StopRequest& request, Tick now, EventList& events) noexcept {
  if (request.place >= kEffectPlaces || request.effect == 0) return;
  if (!holds(request.place, request.effect)) {
    pending_[request.place] = {request.effect, request.reason};
    return;
  }
  const bool finishes =
      request.reason == EndReason::kDisconnected && places_[request.place].finishes_on_close();
  if (!finishes) end(request.place, request.reason, now, events);
}

void Mixer::end_all(EndReason reason, Tick now, EventList& events) noexcept {
  each(
      held_, [&](std::size_t place) { end(place, reason, now, events); });
}

void Mixer::follow_orientation(const MixInputs& inputs, Tick ticks) noexcept {
  const double step = static_cast<double>(ticks) / static_cast<double>(kWorldFade);
  if (inputs.orientation_usable) {
    lost_for_ = 0;
    world_fade_ = oriented_before_ ? std::min(1.0, world_fade_ + step) : 1.0;
    oriented_before_ = true;
  } else {
    lost_for_ = std::min(kOrientationTimeout, lost_for_ + ticks);
    world_fade_ = std::max(0.0, world_fade_ - step);
  }
  // Rounding: two hundred steps of 1/200 do not sum to exactly 0 or 1.
  if (world_fade_ < 1e-9) world_fade_ = 0.0;
  if (world_fade_ > 1.0 - 1e-9) world_fade_ = 1.0;
}

int Mixer::advance(const MixInputs& inputs, Tick ticks, EventList& events) noexcept {
  int top = -1;
  each(held_, [&](std::size_t place) {
    EffectPlace& effect = places_[place];
    if (!effect.advance(inputs.tick, ticks, frames_)) {
      end(place, effect.natural_end(), inputs.tick, events);
      return;
    }
    if (!effect.playing()) return;
    Part& part = parts_[place];
    part = {effect.requested_a(), 1.0};
    if (effect.spec().frame == Frame::kWorld) {
      if (lost_for_ >= kOrientationTimeout) {
        end(place, EndReason::kOrientationLost, inputs.tick, events);
        return;
      }
      part.faded = world_fade_;
      if (world_fade_ == 0.0) {
        effect.note_delivered(part.requested_a > 0.0 ? 0.0 : 1.0, false);
        return;
      }
    }
    set(active_, place);
    top = std::max(top, static_cast<int>(effect.spec().priority));
  });
  return top;
}

MixResult Mixer::sum(const MixInputs& inputs, int top) noexcept {
  MixResult result;
  Vec3 world;
  each(active_, [&](std::size_t place) {
    EffectPlace& effect = places_[place];
    if (effect.spec().priority < top) {
      effect.note_masked();
      return;
    }
    set(received_, place);
    const Part& part = parts_[place];
    if (part.requested_a <= 0.0) return;
    ++sounding_;
    const Vec3 share = gain_ * part.faded * part.requested_a * effect.direction();
    switch (effect.spec().frame) {
      case Frame::kDevice:
        result.field.a = result.field.a + share;
        break;
      case Frame::kWorld:
        world = world + share;
        break;
      case Frame::kCoil:
        result.coil_a = result.coil_a + share;
        break;
    }
  });
  result.field.a = result.field.a + rotate(conjugate(inputs.device_to_world), world);
  result.any = sounding_ > 0;
  result.playing = true;
  return result;
}

MixResult Mixer::mix(const MixInputs& inputs, EventList& events) noexcept {
  const Tick ticks = mixed_before_ ? std::max<Tick>(0, inputs.tick - now_) : 1;
  mixed_before_ = true;
  now_ = inputs.tick;
  gain_ = inputs.gain;
  passed_ = 0.0;
  sounding_ = 0;
  active_ = {};
  received_ = {};
  follow_orientation(inputs, ticks);
  if (empty()) return {};
  if (!inputs.playable) {
    end_all(EndReason::kTripped, inputs.tick, events);
    return {};
  }
  const int top = advance(inputs, ticks, events);
  return top < 0 ? MixResult{} : sum(inputs, top);
}

void Mixer::account(double passed) noexcept {
  passed_ = passed;
  each(received_, [&](std::size_t place) {
    const Part& part = parts_[place];
    const bool sounds = part.requested_a > 0.0;
    places_[place].note_delivered(sounds ? part.faded * passed : 1.0, sounding_ > (sounds ? 1 : 0));
  });
}

void Mixer::fill(std::array<EffectStatus, kEffectPlaces>& status) const noexcept {
  status = {};
  each(held_, [&](std::size_t place) {
    const Part& part = parts_[place];
    const bool on_event = has(received_, place);
    status[place] = {places_[place].effect(), on_event, places_[place].remaining(now_),
                     on_event ? part.requested_a * part.faded * passed_ * gain_ : 0.0};
  });
}

}  // namespace hedgehog::control
