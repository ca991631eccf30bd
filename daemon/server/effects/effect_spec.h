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

/// What the ranges depend on.
struct SpecFacts {
  model::Limits limits;
  double force_slope_n_a = 0.0126;
  const model::PinArray& pins;
  /// A circle's step from pin to pin, degrees (model::pin_pitch_deg).
  double pin_pitch_deg = model::kThesisPitchDeg;
  protocol::Role role = protocol::Role::kObserve;
  /// Device time of tick 0, and now.
  std::int64_t epoch_ns = 0;
  model::Tick now = 0;
};

/// `track`: of effect.play, else nullptr; where its key frames will stand stays open.
/// REQUIRES: `params` went through protocol::with_defaults.
protocol::Result<model::EffectSpec> make_spec(model::EffectMethod method,
                                              const protocol::EffectParams& params,
                                              const SpecFacts& facts,
                                              const KeyframeTrack* track = nullptr);

/// `update` laid over `base`. An error when it would change the kind of end, or says what the
/// effect's method does not have.
protocol::Result<protocol::EffectParams> merged(model::EffectMethod method,
                                                protocol::EffectParams base,
                                                const protocol::EffectParams& update);

}  // namespace hedgehog::server
