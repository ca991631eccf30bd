// SPDX-License-Identifier: MIT
// The key frames of one effect, with the integrals used by admission and forecast.
#pragma once

#include <memory>
#include <vector>

#include "model/effect/keyframes.h"
#include "model/geometry/pin_array.h"
#include "model/vec3.h"
#include "protocol/values/effect_params.h"

namespace hedgehog::server {

/// Moments of `level * direction`: first, and second as the outer product.
struct Moments {
  model::Vec3 first;
  model::Mat3 second{{{}, {}, {}}};
};

struct KeyframeTrack {
  std::vector<model::Keyframe> frames;
  std::vector<Moments> until;           // integrals from the beginning to each key frame, over ms
  double peak = 0.0;                    // the strongest key frame, 0..1
  model::Vec3 peak_direction{1, 0, 0};  // its direction, a unit vector; pattern facing front

  double length_ms() const noexcept { return model::length_ms(frames); }
  /// The means over its first `ms` milliseconds, at rate 1; zero for ms <= 0.
  Moments mean_over(double ms) const noexcept;
};

using KeyframeTrackPtr = std::shared_ptr<const KeyframeTrack>;  // nullptr: no key frames

/// An error contains the key frame whose pin the ball does not have.
protocol::Result<KeyframeTrackPtr> make_keyframe_track(
    const std::vector<protocol::Keyframe>& keyframes, const model::PinArray& pins);

}  // namespace hedgehog::server
