// SPDX-License-Identifier: MIT
// A mixer on virtual time: plays effects tick by tick and records demands and events.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "daemon/control/effects/mixer.h"

namespace hedgehog::control {

class MixerHarness {
 public:
  MixInputs inputs{.tick = 1000, .playable = true, .orientation_usable = true};
  /// Share of the demand that the limiter passes.
  double passed = 1.0;
  Mixer mixer;
  MixResult last;
  std::vector<Event> events;
  std::array<EffectStatus, kEffectPlaces> status{};

  static model::EffectSpec pulse(model::Vec3 direction = {1, 0, 0}, double current_a = 5,
                                 model::Tick duration = 150) {
    model::EffectSpec spec;
    spec.trajectory.direction = direction;
    spec.strength_a = current_a;
    spec.duration = duration;
    return spec;
  }
  static model::EffectSpec hold(model::Vec3 direction = {1, 0, 0}, double current_a = 5,
                                model::Tick lease = 1000) {
    auto spec = pulse(direction, current_a, 0);
    spec.method = model::EffectMethod::kHold;
    spec.lease = lease;
    return spec;
  }
  static model::EffectSpec vibration(model::Waveform waveform, double frequency_hz,
                                     model::Tick lease = 1000) {
    auto spec = hold({1, 0, 0}, 5, lease);
    spec.method = model::EffectMethod::kVibrate;
    spec.waveform = waveform;
    spec.frequency_hz = frequency_hz;
    return spec;
  }

  model::Tick now() const { return inputs.tick; }

  /// Takes effect in the next tick. The place is the effect's number minus 1.
  EffectId start(const model::EffectSpec& spec, EffectId replaces = 0) {
    const EffectId effect = ++last_effect_;
    mixer.start({.effect = effect,
                 .place = place(effect),
                 .replaces = replaces,
                 .replaces_place = replaces == 0 ? std::uint8_t{0} : place(replaces),
                 .spec = spec},
                100 + effect, now(), list_);
    return effect;
  }
  void update(EffectId effect, const model::EffectSpec& spec) {
    mixer.update({effect, place(effect), spec}, now());
  }
  void stop(EffectId effect, EndReason reason = EndReason::kStopped) {
    mixer.stop({effect, place(effect), reason}, now(), list_);
  }
  void end_all(EndReason reason) { mixer.end_all(reason, now(), list_); }

  /// One tick: mix, limit, account. Returns the demand in the device frame.
  model::Vec3 tick() {
    last = mixer.mix(inputs, list_);
    mixer.account(passed);
    mixer.fill(status);
    events.insert(events.end(), list_.begin(), list_.end());
    list_.clear();
    ++inputs.tick;
    return last.field.a;
  }
  std::vector<model::Vec3> run(int ticks) {
    std::vector<model::Vec3> demands;
    demands.reserve(static_cast<std::size_t>(ticks));
    for (int i = 0; i < ticks; ++i) demands.push_back(tick());
    return demands;
  }

  /// The end event of `effect`, if it has ended.
  std::optional<Event> end_of(EffectId effect) const {
    for (const Event& event : events)
      if (event.type == EventType::kEffectEnded && event.effect == effect) return event;
    return std::nullopt;
  }
  std::optional<EndReason> reason_of(EffectId effect) const {
    const auto event = end_of(effect);
    return event ? std::optional(event->end_reason) : std::nullopt;
  }
  const EffectStatus& status_of(EffectId effect) const { return status[place(effect)]; }
  static std::uint8_t place(EffectId effect) {
    return static_cast<std::uint8_t>((effect - 1) % kEffectPlaces);
  }

 private:
  EffectId last_effect_ = 0;
  EventList list_;
};

}  // namespace hedgehog::control
