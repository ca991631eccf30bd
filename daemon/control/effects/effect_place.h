// SPDX-License-Identifier: MIT
// One effect in the mixer: its timing, its phase and its delivered share.
#pragma once

#include <span>
#include <type_traits>

#include "daemon/control/effects/command.h"
#include "daemon/control/snapshot.h"
#include "daemon/control/state/event.h"
#include "model/effect/effect.h"
#include "model/tick.h"

namespace hedgehog::control {

/// Control thread. Trivially copyable. Every function is real-time safe.
class EffectPlace {
 public:
  /// A new effect, applied at tick `now`. Waits for its `delay` or `start_at` (in the past: now).
  void begin(EffectId effect, const model::EffectSpec& spec, model::Tick now) noexcept;

  /// Continues `previous` if it has played, with equal method and waveform: keeps waveform phase
  /// and position on the ring. If both are leased, the attack and the same loop of key frames
  /// continue too, so that a client may send its whole effect every frame.
  void continue_from(const EffectPlace& previous) noexcept;

  /// New parameters; phase and onset are kept, the lease is renewed at `now`.
  void update(const model::EffectSpec& spec, model::Tick now) noexcept;

  /// Advances by `ticks` to `now`, with all loaded key frames. False at its `natural_end`.
  bool advance(model::Tick now, model::Tick ticks,
               std::span<const model::Keyframe> frames) noexcept;

  /// kCompleted or kExpired, or kPreempted when it was masked in every tick.
  EndReason natural_end() const noexcept;

  /// True if it plays to its end after its connection has closed.
  bool finishes_on_close() const noexcept;

  /// Current requested by its own shape in this tick, 0..15; unit vector of it, in its own frame.
  double requested_a() const noexcept;
  model::Vec3 direction() const noexcept;

  /// Result of a tick while playing: masked by a higher priority, or `fraction` (0..1) of the
  /// request delivered, alone or mixed with others.
  void note_masked() noexcept { ++delivery_.masked; }
  void note_delivered(double fraction, bool mixed) noexcept;

  /// Statistics of an effect that ends at `now`.
  Delivery delivery(model::Tick now) const noexcept;
  /// Ticks until it ends by itself.
  model::Tick remaining(model::Tick now) const noexcept;

  EffectId effect() const noexcept { return effect_; }
  const model::EffectSpec& spec() const noexcept { return spec_; }
  const model::EffectPhase& phase() const noexcept { return phase_; }
  /// False while it waits for its onset.
  bool playing() const noexcept { return playing_; }

 private:
  EffectId effect_ = 0;
  bool playing_ = false;
  bool continues_ = false;         // the phase of the effect that it replaced
  bool continues_attack_ = false;  // and its attack
  model::Tick applied_ = 0;
  model::Tick onset_ = 0;
  model::Tick lease_end_ = 0;
  model::EffectSpec spec_;
  model::EffectPhase phase_;
  model::Ring ring_;
  model::KeyframePoint point_;
  Delivery delivery_;
  double delivered_sum_ = 0.0;
  model::Tick counted_ = 0;  // ticks in `delivered_sum_`
};

static_assert(std::is_trivially_copyable_v<EffectPlace>);

}  // namespace hedgehog::control
