// SPDX-License-Identifier: MIT
// Translation of a force-feedback effect of Linux (ff_effect, <linux/input.h>) to an effect of the
// ball. Pure; any thread.
#pragma once

#include <linux/input.h>

#include <chrono>
#include <cstdint>
#include <optional>

#include "protocol/methods/effect.h"

namespace hedgehog::gamepad {

using Milliseconds = std::chrono::milliseconds;

/// Maximum playback of an effect that is neither uploaded nor started again, whatever its length.
inline constexpr Milliseconds kMaxPlay{60'000};

struct TranslationOptions {
  /// Direction of effects without a direction: FF_RUMBLE, and see `sdl_rumble`.
  protocol::Word rumble_direction = protocol::Word::kDown;
  /// FF_PERIODIC with direction 0x4000 is treated as without direction: SDL uploads rumble this
  /// way.
  bool sdl_rumble = true;
  /// Level at the perception threshold (hello.limits.felt_a / current_a), and level of a game's
  /// strongest force: 0 <= felt_level <= full_level <= 1, full_level > 0.
  double felt_level = 0.14;
  double full_level = 1.0;
};

struct TranslatedEffect {
  /// Without slot, gain and end; nullopt: silent.
  std::optional<protocol::EffectStart> start{};
  Milliseconds delay{0};
  /// 1 ms..kMaxPlay; kMaxPlay also for "until it is stopped".
  Milliseconds length = kMaxPlay;
};

/// True for FF_RUMBLE, FF_CONSTANT, FF_RAMP, and FF_PERIODIC of any waveform but FF_CUSTOM. The
/// others require a force between the hand and a base, which a ball in the hand does not have.
bool can_translate(const ff_effect& effect) noexcept;

/// REQUIRES: can_translate(effect).
///  - A force f of 0..1 becomes the level felt + (full - felt) f, and 0 stays 0.
///  - `direction` becomes the side that is pushed: 0x0000 front, 0x4000 right, 0x8000 back, 0xC000
///    left; a negative force pushes the opposite side.
///  - A wave pushes and rests on its one side, with its peak |magnitude| + |offset|.
///  - Envelopes and ramps become key frames. Where attack and fade overlap the fade begins at the
///    end of the attack.
TranslatedEffect translate(const ff_effect& effect, const TranslationOptions& options);

}  // namespace hedgehog::gamepad
