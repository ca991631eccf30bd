// SPDX-License-Identifier: MIT
#include "daemon/control/heading.h"

#include <algorithm>
#include <cmath>

#include "model/units.h"

namespace hedgehog::control {
namespace {

/// Azimuth of the front (device x), seen from above. A vertical front has no azimuth; the device's
/// z axis, which is then horizontal, replaces it.
double azimuth_deg(const model::Quaternion& q) noexcept {
  const model::Vec3 front = rotate(q, {1, 0, 0});
  if (std::hypot(front.x, front.y) > 1e-3)
    return std::atan2(front.y, front.x) * model::kDegreesPerRadian;
  const model::Vec3 top = rotate(q, {0, 0, front.z > 0 ? -1.0 : 1.0});
  return std::atan2(top.y, top.x) * model::kDegreesPerRadian;
}

}  // namespace

void Heading::step(const device::OrientationSample& sample, model::Tick now) noexcept {
  const double length = norm(sample.quaternion);
  if (sample.present && std::abs(length - 1.0) < 0.05 && is_finite(sample.rate_deg_s)) {
    const double k = 1.0 / length;
    const model::Quaternion& q = sample.quaternion;
    present_ = true;
    stamp_ = std::min(sample.stamp, now);
    sensor_ = {k * q.w, k * q.x, k * q.y, k * q.z};
    rate_deg_s_ = sample.rate_deg_s;
    device_to_world_ = yaw_ * sensor_;
  }
  age_ = present_ ? now - stamp_ : 0;
  fresh_ = present_ && age_ <= kFresh;
}

void Heading::recenter(double azimuth) noexcept {
  if (!present_ || !std::isfinite(azimuth)) return;
  yaw_deg_ = std::remainder(azimuth - azimuth_deg(sensor_), 360.0);
  yaw_ = model::axis_angle({0, 0, 1}, yaw_deg_);
  device_to_world_ = yaw_ * sensor_;
}

}  // namespace hedgehog::control
