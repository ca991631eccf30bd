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
  protocol::EffectParams params;  // requested, merged with updates, with defaults; no key frames
  Wave requested_wave;            // set by the client, not by a pattern
  model::EffectSpec spec;         // the range of its key frames is allocated later
  KeyframeTrackPtr track;         // for effect.play
};

}  // namespace hedgehog::server
