// SPDX-License-Identifier: MIT
#include "daemon/device/imu/mounting.h"

#include <cmath>

namespace hedgehog::device {

std::optional<Mounting> Mounting::of(Side front, Side up) noexcept {
  const model::Vec3 x = normal(front);
  const model::Vec3 z = normal(up);
  if (dot(x, z) != 0.0) return std::nullopt;
  const model::Vec3 y = cross(z, x);
  // Matrix with the columns x, y, z (the ball's axes in the sensor's) to a quaternion: the largest
  // of its four numbers first (Shepperd 1978), because half turns have w = 0.
  const double trace = x.x + y.y + z.z;
  model::Quaternion q;
  if (trace > 0.0)
    q = {trace + 1.0, y.z - z.y, z.x - x.z, x.y - y.x};
  else if (x.x >= y.y && x.x >= z.z)
    q = {y.z - z.y, 1.0 + x.x - y.y - z.z, y.x + x.y, z.x + x.z};
  else if (y.y >= z.z)
    q = {z.x - x.z, y.x + x.y, 1.0 - x.x + y.y - z.z, z.y + y.z};
  else
    q = {x.y - y.x, z.x + x.z, z.y + y.z, 1.0 - x.x - y.y + z.z};
  const double k = 1.0 / norm(q);
  Mounting made;
  made.ball_to_sensor_ = {k * q.w, k * q.x, k * q.y, k * q.z};
  return made;
}

}  // namespace hedgehog::device
