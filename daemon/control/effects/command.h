// SPDX-License-Identifier: MIT
// Commands of the io thread, with ranges and ownership already checked. Trivially copyable; sent by
// spsc queue. Stop requests bypass the queue: see StopBoard in mailbox.h.
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

/// Number of an effect: unique while the daemon runs, 0 is none.
using EffectId = std::uint32_t;

/// Places for effects in the mixer. io assigns at most kMaxEffects to playing effects; the others
/// hold effects that were replaced or have ended until io has read their last state.
inline constexpr int kEffectPlaces = 128;
inline constexpr int kMaxEffects = 64;
inline constexpr int kMaxCommandsPerTick = 64;

/// Capacity for the key frames of all effects. io allocates it: a range is free again after
/// `effect_ended` of every effect that uses it.
inline constexpr int kKeyframeCapacity = 2048;

/// A slice of key frames; those of an effect precede its start, in the same tick.
struct LoadKeyframes {
  static constexpr int kMaxFrames = 11;
  std::uint16_t first = 0;
  std::uint8_t count = 0;
  std::array<model::Keyframe, kMaxFrames> frames{};

  /// Number of these commands that load `count` key frames.
  static constexpr std::size_t commands_for(std::size_t count) noexcept {
    return (count + kMaxFrames - 1) / kMaxFrames;
  }
  /// The command with index `command`, when the first key frame goes to slot `first`.
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
  std::uint8_t place = 0;  // assigned by io after it read `effect_ended` of the previous effect
  /// Ends as `replaced` in this tick (0: none); its phase is kept if method and waveform are equal.
  EffectId replaces = 0;
  std::uint8_t replaces_place = 0;
  model::EffectSpec spec;
};

/// New parameters for a playing effect: phase kept, lease renewed. Ignored if it has ended.
struct UpdateEffect {
  EffectId effect = 0;
  std::uint8_t place = 0;
  model::EffectSpec spec;
};

/// Ignored if an emergency stop was requested after it: the stop bypasses the queue, this does not.
struct Arm {
  std::uint32_t generation = 0;  // `Mailbox::emergency_generation` at the request
};

/// Sets the present front direction to `azimuth_deg`.
struct Recenter {
  double azimuth_deg = 0.0;
};

struct SetGain {
  double gain = 1.0;
};

struct SetLimits {
  model::Limits limits;
};

/// The ball may have been replaced: thermal state unknown, no current until a client arms it.
struct ResetBall {};

/// Sends the board to its boot loader, unless it is armed or being armed.
struct EnterBootLoader {};

struct Command {
  /// Incremented with each command; a status with `applied_seq` at or above it includes its effect.
  std::uint64_t seq = 0;
  std::variant<StartEffect, UpdateEffect, LoadKeyframes, Arm, Recenter, SetGain, SetLimits,
               ResetBall, EnterBootLoader>
      what;
};

static_assert(std::is_trivially_copyable_v<Command>);

}  // namespace hedgehog::control
