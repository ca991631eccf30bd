// SPDX-License-Identifier: MIT
// Orientation of the ball: the sensor's, rotated so that the front points to the azimuth set by the
// last `orientation.recenter`, and its freshness.
#pragma once

#include "daemon/device/orientation.h"
#include "model/quaternion.h"
#include "model/tick.h"

namespace hedgehog::control {

/// Control thread; real-time safe, trivially copyable. Until the first recentre the world's x is
/// the sensor's own: the front direction when its fusion started, or that of an external feeder.
class Heading {
 public:
  static constexpr model::Tick kFresh = 100;  // older orientations are not used

  /// Applies the tick's latest sample. An invalid rotation counts as no sample.
  void step(const device::OrientationSample& sample, model::Tick now) noexcept;
  /// Sets the present front to `azimuth_deg`, anticlockwise from above; ignored if not `present`.
  void recenter(double azimuth_deg) noexcept;

  /// At least one valid orientation has been received.
  bool present() const noexcept { return present_; }
  bool fresh() const noexcept { return fresh_; }
  model::Tick age() const noexcept { return age_; }
  /// Device -> world, recentred; the last known one.
  const model::Quaternion& device_to_world() const noexcept { return device_to_world_; }
  const model::Vec3& rate_deg_s() const noexcept { return rate_deg_s_; }
  double yaw_offset_deg() const noexcept { return yaw_deg_; }

 private:
  bool present_ = false;
  bool fresh_ = false;
  model::Tick age_ = 0;
  model::Tick stamp_ = 0;
  model::Quaternion sensor_;
  model::Vec3 rate_deg_s_;
  double yaw_deg_ = 0.0;
  model::Quaternion yaw_;
  model::Quaternion device_to_world_;
};

}  // namespace hedgehog::control
