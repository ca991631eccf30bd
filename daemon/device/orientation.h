// SPDX-License-Identifier: MIT
// Last sample of the ball's orientation sensor.
#pragma once

#include "model/quaternion.h"
#include "model/tick.h"
#include "model/vec3.h"

namespace hedgehog::device {

/// Trivially copyable. The sensor thread (io if `imu.type` is `external`) writes, control reads.
struct OrientationSample {
  bool present = false;          // false: no sample yet
  model::Quaternion quaternion;  // device -> world of the sensor, before `orientation.recenter`
  model::Vec3 rate_deg_s;
  model::Tick stamp = 0;  // of the measurement
};

}  // namespace hedgehog::device
