// SPDX-License-Identifier: MIT
// Orientation of the ball: the sensor's, rotated so that the front points where the last
// `orientation.recenter` set it, and its freshness.
#pragma once

#include "daemon/device/orientation.h"
#include "model/quaternion.h"
#include "model/tick.h"

namespace hedgehog::control {

/// Control thread; real-time safe, trivially copyable. Until the first recentre the world's x is
/// the sensor's own: where the front pointed when its fusion started, or what an external feeder
/// says.
class Heading {
 public:
  /// Older orientations are not used.
  static constexpr model::Tick kFresh = 100;

  /// The tick's latest sample. Numbers that are no rotation count as none.
  void step(const device::OrientationSample& sample, model::Tick now) noexcept;
  /// The front points at `azimuth_deg` (anticlockwise from above) now. Ignored when no orientation
  /// is known.
  void recenter(double azimuth_deg) noexcept;

  /// An orientation has ever been known.
  bool present() const noexcept { return present_; }
  bool fresh() const noexcept { return fresh_; }
  model::Tick age() const noexcept { return age_; }
  /// Device -> world, recentred; the last one known.
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
