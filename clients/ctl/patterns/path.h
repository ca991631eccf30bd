// SPDX-License-Identifier: MIT
// A path on the sphere over time, reduced to few key frames.
#pragma once

#include <cstdint>
#include <vector>

#include "model/vec3.h"
#include "protocol/values/effect_params.h"

namespace hedgehog::client {

struct PathPoint {
  std::int64_t t_ms = 0;  // 0..60 000, strictly increasing
  model::Vec3 direction{1, 0, 0};
};

struct SimplifiedPath {
  /// At most 256, including the first and the last point.
  std::vector<protocol::Keyframe> keyframes;
  /// The largest angle between a point and the played direction at its time.
  double error_deg = 0.0;
};

/// Ramer-Douglas-Peucker with time: the section with the largest error is split at the point of
/// that error, until no error exceeds `tolerance_deg` or there are 256 key frames. An error is the
/// angle at the same time, since key frames have times. `points` is not empty; all key frames get
/// `level`.
SimplifiedPath simplify_path(const std::vector<PathPoint>& points, double tolerance_deg,
                             double level);

}  // namespace hedgehog::client
