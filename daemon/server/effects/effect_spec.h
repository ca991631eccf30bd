// SPDX-License-Identifier: MIT
// Effect parameters -> model::EffectSpec, with the ranges that depend on ball and role.
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
  double pin_pitch_deg = model::kThesisPitchDeg;  // step of a circle (model::pin_pitch_deg)
  protocol::Role role = protocol::Role::kObserve;
  std::int64_t epoch_ns = 0;  // device time of tick 0
  model::Tick now = 0;
};

/// `track`: for effect.play, else nullptr; the range of its key frames is not set. REQUIRES:
/// `params` was returned by protocol::with_defaults.
protocol::Result<model::EffectSpec> make_spec(model::EffectMethod method,
                                              const protocol::EffectParams& params,
                                              const SpecFacts& facts,
                                              const KeyframeTrack* track = nullptr);

/// `base` with the fields set in `update`. An error if that would change the kind of end, or
/// contains a field that the effect's method does not have.
protocol::Result<protocol::EffectParams> merged(model::EffectMethod method,
                                                protocol::EffectParams base,
                                                const protocol::EffectParams& update);

}  // namespace hedgehog::server
