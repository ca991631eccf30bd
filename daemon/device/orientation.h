// SPDX-License-Identifier: MIT
// Last sample of the ball's orientation sensor.
#pragma once

#include "model/quaternion.h"
#include "model/tick.h"
#include "model/vec3.h"

namespace hedgehog::device {

/// Trivially copyable; written by the sensor thread (or io, when `imu.type` is `external`), read by
/// control.
struct OrientationSample {
  /// False: no sample yet.
  bool present = false;
  /// Device -> world of the sensor, before `orientation.recenter`.
  model::Quaternion quaternion;
  model::Vec3 rate_deg_s;
  /// Tick of the measurement.
  model::Tick stamp = 0;
};

}  // namespace hedgehog::device
