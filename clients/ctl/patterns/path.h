// SPDX-License-Identifier: MIT
// A path on the sphere over time as few key frames.
#pragma once

#include <cstdint>
#include <vector>

#include "model/vec3.h"
#include "protocol/values/effect_params.h"

namespace hedgehog::client {

struct PathPoint {
  std::int64_t t_ms = 0;  // 0..60 000, above the one before it
  model::Vec3 direction{1, 0, 0};
};

struct SimplifiedPath {
  /// At most 256; the first and the last point are among them.
  std::vector<protocol::Keyframe> keyframes;
  /// The largest angle between a point and what plays at its time.
  double error_deg = 0.0;
};

/// Ramer-Douglas-Peucker with time: the part with the largest error is split at the point where it
/// is, until no error is above `tolerance_deg` or there are 256 key frames. An error is the angle
/// at the same time, since key frames say when as well as where. `points` is not empty; all key
/// frames get `level`.
SimplifiedPath simplify_path(const std::vector<PathPoint>& points, double tolerance_deg,
                             double level);

}  // namespace hedgehog::client
