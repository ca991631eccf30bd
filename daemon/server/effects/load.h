// SPDX-License-Identifier: MIT
// Average load of effects on the three windings: for thermal forecasts, cheap enough for admission.
#pragma once

#include "daemon/server/effects/keyframe_track.h"
#include "model/coils.h"
#include "model/effect/effect.h"
#include "model/limit/forecast.h"
#include "model/quaternion.h"

namespace hedgehog::server {

/// Winding currents. Steady effects (one direction, constant waveform) add as vectors; the others
/// are treated as independent of each other.
struct Load {
  model::Vec3 mean_a;
  model::Vec3 variance_a2;
  model::Vec3 steady_a;    // sum of the steady effects
  double varying_a = 0.0;  // sum of the peaks of the others

  double peak_a() const noexcept { return model::norm(steady_a) + varying_a; }
  model::RequestedCurrents requested() const noexcept;
  friend Load operator+(const Load& a, const Load& b) noexcept;
};

/// Load without attack, fade and end. World-frame effects at the present orientation. `track`: its
/// key frames, nullptr if it has none.
Load load_of(const model::EffectSpec& spec, const KeyframeTrack* track,
             const model::CoilModel& coils, const model::Quaternion& device_to_world) noexcept;

/// Maximum current requested by the effect.
double peak_a(const model::EffectSpec& spec, const KeyframeTrack* track) noexcept;

/// `load` scaled by the owner's gain and the limit of the sum.
Load scaled(const Load& load, double factor) noexcept;

/// Direction at the onset, or of the strongest key frame: a unit vector in the device frame.
model::Vec3 onset_direction(const model::EffectSpec& spec, const KeyframeTrack* track,
                            const model::CoilModel& coils,
                            const model::Quaternion& device_to_world) noexcept;

}  // namespace hedgehog::server
