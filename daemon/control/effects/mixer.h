// SPDX-License-Identifier: MIT
// All effects that wait or play, and what they ask of the coils together:
// mixing, shapes and ends as protocol/README.md has them.
//
// Order within one tick: `stop` for every stop request, `start` and `update` for every command in
// order, `mix` once, then the limiter, then `account` once, then `fill` when a snapshot is made.
//
// - An effect applied at tick t with delay d plays from tick t + d on. With duration n its first
//   silent tick, `Delivery::offset`, is onset + n (`completed`). A lease runs from the onset or the
//   last update, whichever is later (`expired`).
// - Only the effects of the highest active priority are summed. The others keep their clocks and
//   count masked ticks. One that ends by itself without a single tick felt and was masked ends as
//   `preempted`; one that is stopped, replaced or tripped keeps that reason.
// - A world-frame effect without orientation is not active, so it masks no other. Orientation not
//   usable: world effects fade out in 200 ms and wait; they fade in again in 200 ms when it comes
//   back, and end as `orientation_lost` when it has been away for 2 s.
// - `Delivery::min` and `mean` count the ticks in which the effect was not masked: the limiter's
//   fraction times the world fade. The owner's gain is not counted as a loss. Both are 0 for an
//   effect that never had such a tick.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "daemon/control/effects/command.h"
#include "daemon/control/effects/effect_place.h"
#include "daemon/control/snapshot.h"
#include "daemon/control/state/event_list.h"
#include "daemon/control/step_inputs.h"
#include "model/coils.h"
#include "model/quaternion.h"
#include "model/tick.h"

namespace hedgehog::control {

struct MixInputs {
  model::Tick tick = 0;
  /// Armed. When false every effect ends as `tripped`.
  bool playable = false;
  /// An orientation not older than 100 ms is known.
  bool orientation_usable = false;
  /// The last one known, recentred; also used while the world effects fade out.
  model::Quaternion device_to_world{};
  /// The owner's comfort setting, 0..1; scales everything.
  double gain = 1.0;
};

/// The winding currents asked for are `currents_for(field) + coil_a`.
struct MixResult {
  /// Sum of the device-frame and world-frame effects, A, not limited.
  model::FieldDemand field;
  /// Sum of the coil-frame effects: raw winding currents, A, not limited.
  model::Vec3 coil_a;
  /// Some effect was summed with a strength above zero.
  bool any = false;
  /// Some effect plays, maybe in a silent part of its waveform; waiting for its onset is not
  /// playing.
  bool playing = false;
};

/// Lives on the control thread. Trivially copyable: the flight recorder copies it. Every function
/// is real-time safe: no allocation, lock, clock or exception.
class Mixer {
 public:
  static constexpr model::Tick kWorldFade = 200;
  static constexpr model::Tick kOrientationPatience = 2000;
  /// Longest timed effect that may outlive its connection.
  static constexpr model::Tick kLongestFinish = 2000;

  /// Stores key frames; those that do not fit are dropped.
  void load(const LoadKeyframes& command) noexcept;
  /// Applies a start: `effect_started` with `seq`. An effect whose stop came first ends at once.
  void start(const StartEffect& command, std::uint64_t seq, model::Tick now,
             EventList& events) noexcept;
  /// Ignored when the effect has ended meanwhile.
  void update(const UpdateEffect& command, model::Tick now) noexcept;
  /// Ends an effect, or remembers to end it at its start. `kDisconnected` lets those play out that
  /// may.
  void stop(const StopRequest& request, model::Tick now, EventList& events) noexcept;
  /// Trip, emergency stop, disarmed, device gone.
  void end_all(EndReason reason, model::Tick now, EventList& events) noexcept;

  /// Moves every effect to `inputs.tick`, ends those whose time has come, and sums the rest. Ticks
  /// that were skipped since the last call pass for the effects too.
  MixResult mix(const MixInputs& inputs, EventList& events) noexcept;

  /// After the limiter and the gate: `passed` is what they let through of `mix`'s result, 0..1 (1
  /// when nothing was asked). Call it once after every `mix`.
  void account(double passed) noexcept;

  /// The state of every place after this tick.
  void fill(std::array<EffectStatus, kEffectPlaces>& status) const noexcept;

  /// No effect waits or plays.
  bool empty() const noexcept { return (held_[0] | held_[1]) == 0; }
  /// 0: world-frame effects are silent, 1: in full.
  double world_fade() const noexcept { return world_fade_; }

 private:
  using Mask = std::array<std::uint64_t, kEffectPlaces / 64>;
  struct PendingStop {
    EffectId effect = 0;
    EndReason reason = EndReason::kStopped;
  };
  /// What an effect contributed in this tick.
  struct Part {
    double asked_a = 0.0;
    double faded = 1.0;  // 0..1, the world fade or 1
  };

  bool holds(std::size_t place, EffectId effect) const noexcept;
  void end(std::size_t place, EndReason reason, model::Tick now, EventList& events) noexcept;
  void follow_orientation(const MixInputs& inputs, model::Tick ticks) noexcept;
  /// Advances all, returns the highest active priority (-1: none).
  int advance(const MixInputs& inputs, model::Tick ticks, EventList& events) noexcept;
  MixResult sum(const MixInputs& inputs, int top) noexcept;

  std::array<EffectPlace, kEffectPlaces> places_{};
  std::array<model::Keyframe, kKeyframeCapacity> frames_{};
  std::array<Part, kEffectPlaces> parts_{};
  std::array<PendingStop, kEffectPlaces> pending_{};
  Mask held_{};       // waiting or playing
  Mask active_{};     // playing, and not without orientation, in this tick
  Mask received_{};   // active and of the highest active priority
  int sounding_ = 0;  // how many of `received_` asked for more than zero
  double passed_ = 1.0;
  double gain_ = 1.0;
  double world_fade_ = 0.0;
  model::Tick lost_for_ = 0;
  model::Tick now_ = 0;
  bool mixed_before_ = false;
  bool oriented_before_ = false;
};

static_assert(std::is_trivially_copyable_v<Mixer>);

}  // namespace hedgehog::control
