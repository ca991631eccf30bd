// SPDX-License-Identifier: MIT
// All effects that wait or play, and the sum of the currents that they request; mixing, shapes and
// ends are specified in protocol/README.md. Order within one tick: `stop` for every stop request,
// `start` and `update` for every command in order, `mix`, the limiter, `account`, and `fill` when a
// snapshot is made.
// - An effect applied at tick t with delay d plays from t + d on. With duration n its first silent
//   tick, `Delivery::offset`, is onset + n. A lease runs from the later of onset and last update.
// - Only the effects of the highest active priority are summed. The others keep their timing and
//   count masked ticks; one that ends by itself, masked in every tick, ends as `preempted`.
// - World-frame effects without a usable orientation fade out in 200 ms, then wait without masking
//   others; they fade in again in 200 ms, or end as `orientation_lost` after 2 s.
// - `Delivery::min` and `mean`: the limiter's fraction times the world fade, without the owner's
//   gain, over the ticks in which the effect was not masked; 0 if there was none.
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
  bool playable = false;                // armed; when false every effect ends as `tripped`
  bool orientation_usable = false;      // known, and not older than 100 ms
  model::Quaternion device_to_world{};  // last known, recentred; also used during the fade-out
  double gain = 1.0;                    // the owner's comfort setting, 0..1; scales everything
};

/// The requested winding currents are `currents_for(field) + coil_a`.
struct MixResult {
  model::FieldDemand field;  // sum of the device-frame and world-frame effects, A, not limited
  model::Vec3 coil_a;        // sum of the coil-frame effects: raw winding currents, not limited
  bool any = false;          // some effect was summed with a strength above zero
  bool playing = false;      // an effect plays, even silently; not while it waits for its onset
};

/// Control thread; real-time safe, trivially copyable: the flight recorder copies it.
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
  void update(const UpdateEffect& command, model::Tick now) noexcept;
  /// Ends an effect now or at its start. `kDisconnected` does not end effects that finish on close.
  void stop(const StopRequest& request, model::Tick now, EventList& events) noexcept;
  /// For a trip, emergency stop, disarming or a disconnected device.
  void end_all(EndReason reason, model::Tick now, EventList& events) noexcept;

  /// Advances every effect to `inputs.tick`, skipped ticks included; ends those due, sums the rest.
  MixResult mix(const MixInputs& inputs, EventList& events) noexcept;

  /// Once after every `mix`. `passed`: share that limiter and gate passed, 0..1 (no request: 1).
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
