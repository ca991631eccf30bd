// SPDX-License-Identifier: MIT
#include "model/geometry/direction.h"

#include <cmath>
#include <numbers>

#include "model/units.h"

namespace hedgehog::model {

std::string_view side_name(const Vec3& v) noexcept {
  const NamedDirection* best = &kNamedDirections.front();
  for (const NamedDirection& known : kNamedDirections)
    if (dot(known.vector, v) > dot(best->vector, v)) best = &known;
  return best->name;
}

Vec3 vector_of(const AzimuthElevation& angles) noexcept {
  const double azimuth = angles.azimuth_deg / kDegreesPerRadian;
  const double elevation = angles.elevation_deg / kDegreesPerRadian;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

AzimuthElevation angles_of(const Vec3& v) noexcept {
  const double across = std::hypot(v.x, v.y);
  const bool has_azimuth = across > 1e-12 * norm(v);
  return {has_azimuth ? std::atan2(v.y, v.x) * kDegreesPerRadian : 0.0,
          norm(v) > 0.0 ? std::atan2(v.z, across) * kDegreesPerRadian : 0.0};
}

}  // namespace hedgehog::model
