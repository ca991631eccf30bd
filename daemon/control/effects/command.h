// SPDX-License-Identifier: MIT
// Commands of the io thread, with ranges and ownership already checked. Trivially copyable; travels
// by spsc queue. Stopping never queues: see StopBoard in mailbox.h.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <variant>

#include "model/coils.h"
#include "model/effect/effect.h"
#include "model/effect/keyframes.h"
#include "model/limit/limits.h"

namespace hedgehog::control {

/// Number of an effect: never used twice while the daemon runs, 0 is none.
using EffectId = std::uint32_t;

/// Places for effects in the mixer. io hands out at most 64 to playing effects; the rest serves
/// those that were replaced or have ended and wait for io to take their last state.
inline constexpr int kEffectPlaces = 128;
inline constexpr int kMaxEffects = 64;
inline constexpr int kMaxCommandsPerTick = 64;

/// Capacity for the key frames of all effects together, in the mixer. io allocates it: a
/// part is free again when `effect_ended` of all who play from it was taken.
inline constexpr int kKeyframeCapacity = 2048;

/// Some key frames; those of an effect come before its start, in the same tick.
struct LoadKeyframes {
  static constexpr int kMaxFrames = 11;
  std::uint16_t first = 0;
  std::uint8_t count = 0;
  std::array<model::Keyframe, kMaxFrames> frames{};

  /// How many of these load `count` key frames.
  static constexpr std::size_t commands_for(std::size_t count) noexcept {
    return (count + kMaxFrames - 1) / kMaxFrames;
  }
  /// The one of them with index `command`, when the first key frame goes to place `first`.
  /// REQUIRES: command < commands_for(all.size()).
  static LoadKeyframes slice(std::span<const model::Keyframe> all, std::size_t first,
                             std::size_t command) noexcept {
    const std::size_t from = command * kMaxFrames;
    const std::size_t count = std::min<std::size_t>(kMaxFrames, all.size() - from);
    LoadKeyframes load;
    load.first = static_cast<std::uint16_t>(first + from);
    load.count = static_cast<std::uint8_t>(count);
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(from), count, load.frames.begin());
    return load;
  }
};

struct StartEffect {
  EffectId effect = 0;
  /// The place that io chose: free until `effect_ended` of its last holder was taken.
  std::uint8_t place = 0;
  /// This effect ends as `replaced` in the same tick (0: none), its phase is kept when method and
  /// waveform are the same.
  EffectId replaces = 0;
  std::uint8_t replaces_place = 0;
  model::EffectSpec spec;
};

/// New parameters for a playing effect: phase kept, lease renewed. Ignored when it has ended
/// meanwhile.
struct UpdateEffect {
  EffectId effect = 0;
  std::uint8_t place = 0;
  model::EffectSpec spec;
};

/// Ignored once an emergency stop was asked for that it does not know of: it waited in a queue, the
/// stop did not.
struct Arm {
  /// `Mailbox::emergency_generation` when the arming was asked for.
  std::uint32_t generation = 0;
};

/// The front points at `azimuth_deg` now.
struct Recenter {
  double azimuth_deg = 0.0;
};

struct SetGain {
  double gain = 1.0;
};

struct SetLimits {
  model::Limits limits;
};

/// The ball is another one than before, or may be: nothing is known of its heat, and it does not
/// push before somebody arms it.
struct ForgetBall {};

/// The board goes into its boot loader, unless it is armed or being armed.
struct EnterBootLoader {};

struct Command {
  /// Rises by one with each command; a status whose `applied_seq` has reached it shows its
  /// consequence.
  std::uint64_t seq = 0;
  std::variant<StartEffect, UpdateEffect, LoadKeyframes, Arm, Recenter, SetGain, SetLimits,
               ForgetBall, EnterBootLoader>
      what;
};

static_assert(std::is_trivially_copyable_v<Command>);

}  // namespace hedgehog::control
