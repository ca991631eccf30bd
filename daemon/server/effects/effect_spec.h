// SPDX-License-Identifier: MIT
// Effect parameters -> model::EffectSpec, with the ranges that depend on the ball and on the
// client's role.
#pragma once

#include <cstdint>

#include "daemon/server/effects/keyframe_track.h"
#include "model/effect/effect.h"
#include "model/geometry/pin_array.h"
#include "model/limit/limits.h"
#include "model/tick.h"
#include "protocol/values/effect_params.h"
#include "protocol/wire/error.h"
#include "protocol/wire/role.h"

namespace hedgehog::server {

/// Inputs of the ranges.
struct SpecFacts {
  model::Limits limits;
  double force_slope_n_a = 0.0126;
  const model::PinArray& pins;
  /// A circle's step from pin to pin, degrees (model::pin_pitch_deg).
  double pin_pitch_deg = model::kThesisPitchDeg;
  protocol::Role role = protocol::Role::kObserve;
  /// Device time of tick 0, ns, and the present tick.
  std::int64_t epoch_ns = 0;
  model::Tick now = 0;
};

/// `track`: for effect.play, else nullptr; the range of its key frames is not set. REQUIRES:
/// `params` was returned by protocol::with_defaults.
protocol::Result<model::EffectSpec> make_spec(model::EffectMethod method,
                                              const protocol::EffectParams& params,
                                              const SpecFacts& facts,
                                              const KeyframeTrack* track = nullptr);

/// `base` overwritten by the fields set in `update`. An error if that would change the kind of end,
/// or contains a field that the effect's method does not have.
protocol::Result<protocol::EffectParams> merged(model::EffectMethod method,
                                                protocol::EffectParams base,
                                                const protocol::EffectParams& update);

}  // namespace hedgehog::server
