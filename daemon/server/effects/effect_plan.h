// SPDX-License-Identifier: MIT
// A resolved request to play: its complete parameters, its spec, and its key frames.
#pragma once

#include <optional>

#include "daemon/server/effects/keyframe_track.h"
#include "model/effect/effect.h"
#include "protocol/values/effect_params.h"

namespace hedgehog::server {

/// Waveform fields that a pattern may set, unless the client does.
struct Wave {
  std::optional<model::Waveform> waveform{};
  std::optional<double> frequency_hz{};
  std::optional<double> on_fraction{};
};

struct EffectPlan {
  /// As requested, merged with updates, defaults filled in; without key frames.
  protocol::EffectParams params;
  /// As set by the client; a pattern's own fields do not count.
  Wave requested_wave;
  model::EffectSpec spec;
  /// For effect.play; its range in control's key frames is allocated later.
  KeyframeTrackPtr track;
};

}  // namespace hedgehog::server
