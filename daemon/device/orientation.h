// SPDX-License-Identifier: MIT
// Orientation of the ball as of its sensor's last sample.
#pragma once

#include "model/quaternion.h"
#include "model/tick.h"
#include "model/vec3.h"

namespace hedgehog::device {

/// Trivially copyable; written by the sensor's reader (or io, when `imu.type` is `external`), read
/// by control.
struct OrientationSample {
  /// False: no orientation has ever been known.
  bool present = false;
  /// Device -> world of the sensor, before `orientation.recenter`.
  model::Quaternion quaternion;
  model::Vec3 rate_deg_s;
  /// When it was measured.
  model::Tick stamp = 0;
};

}  // namespace hedgehog::device
