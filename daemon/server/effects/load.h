// SPDX-License-Identifier: MIT
// Average load of effects on the three windings: enough to forecast heat, and cheap enough for
// every admission.
#pragma once

#include "daemon/server/effects/keyframe_track.h"
#include "model/coils.h"
#include "model/effect/effect.h"
#include "model/limit/forecast.h"
#include "model/quaternion.h"

namespace hedgehog::server {

/// Winding currents, A. Steady effects (one direction, constant waveform) add as vectors; the
/// others are taken as independent of each other.
struct Load {
  model::Vec3 mean_a;
  model::Vec3 variance_a2;
  /// Sum of the steady effects, and the sum of the peaks of the others.
  model::Vec3 steady_a;
  double varying_a = 0.0;

  double peak_a() const noexcept { return model::norm(steady_a) + varying_a; }
  model::AskedCurrents asked() const noexcept;
  friend Load operator+(const Load& a, const Load& b) noexcept;
};

/// As if it played on for ever with neither attack nor fade. World-frame effects as the ball lies
/// now. `track`: its key frames, nullptr when it has none.
Load load_of(const model::EffectSpec& spec, const KeyframeTrack* track,
             const model::CoilModel& coils, const model::Quaternion& device_to_world) noexcept;

/// The most that the effect asks for, A.
double peak_a(const model::EffectSpec& spec, const KeyframeTrack* track) noexcept;

/// `load` through the owner's gain and the sum's limit.
Load scaled(const Load& load, double factor) noexcept;

/// Where the effect begins, or where its strongest key frame points: a unit vector in the device
/// frame.
model::Vec3 onset_direction(const model::EffectSpec& spec, const KeyframeTrack* track,
                            const model::CoilModel& coils,
                            const model::Quaternion& device_to_world) noexcept;

}  // namespace hedgehog::server
