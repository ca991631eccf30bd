// SPDX-License-Identifier: MIT
// All effects that wait or play, and the currents that they request together; mixing, shapes and
// ends are specified in protocol/README.md.
//
// Order within one tick: `stop` for every stop request, `start` and `update` for every command in
// order, `mix` once, then the limiter, then `account` once, then `fill` when a snapshot is made.
//
// - An effect applied at tick t with delay d plays from tick t + d on. With duration n its first
//   silent tick, `Delivery::offset`, is onset + n (`completed`). A lease runs from the onset or the
//   last update, whichever is later (`expired`).
// - Only the effects of the highest active priority are summed. The others keep their timing and
//   count masked ticks. One that ends by itself and was masked in every tick ends as
//   `preempted`; one that is stopped, replaced or tripped keeps that reason.
// - A world-frame effect without orientation is not active, so it masks no other. Orientation not
//   usable: world effects fade out in 200 ms and wait; they fade in again in 200 ms when it is
//   restored, and end as `orientation_lost` after 2 s without it.
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
  /// The orientation is known and not older than 100 ms.
  bool orientation_usable = false;
  /// The last known orientation, recentred; also used while the world effects fade out.
  model::Quaternion device_to_world{};
  /// The owner's comfort setting, 0..1; scales everything.
  double gain = 1.0;
};

/// The requested winding currents are `currents_for(field) + coil_a`.
struct MixResult {
  /// Sum of the device-frame and world-frame effects, A, not limited.
  model::FieldDemand field;
  /// Sum of the coil-frame effects: raw winding currents, A, not limited.
  model::Vec3 coil_a;
  /// Some effect was summed with a strength above zero.
  bool any = false;
  /// At least one effect plays, possibly in a silent part of its waveform; waiting for the onset is
  /// not playing.
  bool playing = false;
};

/// Control thread. Trivially copyable: the flight recorder copies it. Every function is real-time
/// safe: no allocation, lock, clock or exception.
class Mixer {
 public:
  static constexpr model::Tick kWorldFade = 200;
  static constexpr model::Tick kOrientationTimeout = 2000;
  /// Longest timed effect that may play on after its connection has closed.
  static constexpr model::Tick kLongestFinish = 2000;

  /// Stores key frames; dropped beyond the capacity.
  void load(const LoadKeyframes& command) noexcept;
  /// Starts an effect and reports `effect_started` with `seq`. Ends at once if its stop came first.
  void start(const StartEffect& command, std::uint64_t seq, model::Tick now,
             EventList& events) noexcept;
  /// Ignored if the effect has ended meanwhile.
  void update(const UpdateEffect& command, model::Tick now) noexcept;
  /// Ends an effect, or stores the stop until its start. `kDisconnected` does not end effects that
  /// finish on close.
  void stop(const StopRequest& request, model::Tick now, EventList& events) noexcept;
  /// For a trip, emergency stop, disarming or a disconnected device.
  void end_all(EndReason reason, model::Tick now, EventList& events) noexcept;

  /// Advances every effect to `inputs.tick`, ends those that are due, and sums the rest. Ticks
  /// skipped since the last call count for the effects too.
  MixResult mix(const MixInputs& inputs, EventList& events) noexcept;

  /// After the limiter and the gate: `passed` is the share of `mix`'s result that they passed, 0..1
  /// (1 when nothing was requested). Call it once after every `mix`.
  void account(double passed) noexcept;

  /// The state of every place after this tick.
  void fill(std::array<EffectStatus, kEffectPlaces>& status) const noexcept;

  /// No effect waits or plays.
  bool empty() const noexcept { return (held_[0] | held_[1]) == 0; }
  /// Amplitude of the world-frame effects, 0..1.
  double world_fade() const noexcept { return world_fade_; }

 private:
  using Mask = std::array<std::uint64_t, kEffectPlaces / 64>;
  struct PendingStop {
    EffectId effect = 0;
    EndReason reason = EndReason::kStopped;
  };
  /// Contribution of an effect in this tick.
  struct Part {
    double requested_a = 0.0;
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
  Mask active_{};     // playing, and not faded out without orientation, in this tick
  Mask received_{};   // active and of the highest active priority
  int sounding_ = 0;  // number of `received_` that requested more than zero
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
