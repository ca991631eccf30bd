// SPDX-License-Identifier: MIT
// Directions by name, by angles and by pin. A direction is the one in which the pins push out
// ("towards"), never the origin of a force. Frame: x front, y left, z up; right-handed (REP-103).
#pragma once

#include <array>
#include <string_view>

#include "model/vec3.h"

namespace hedgehog::model {

struct NamedDirection {
  std::string_view name;
  Vec3 vector;
};

/// The six direction names of the protocol.
inline constexpr std::array<NamedDirection, 6> kNamedDirections{{
    {"up", {0, 0, 1}},
    {"down", {0, 0, -1}},
    {"left", {0, 1, 0}},
    {"right", {0, -1, 0}},
    {"front", {1, 0, 0}},
    {"back", {-1, 0, 0}},
}};

/// The name nearest to `v`; "up" for a zero vector. For display: "at pin 34, on the left".
std::string_view side_name(const Vec3& v) noexcept;

struct AzimuthElevation {
  double azimuth_deg = 0.0;    // anticlockwise seen from above, 0 front, 90 left, -180..180
  double elevation_deg = 0.0;  // from the horizon, 90 up, -90..90
};

/// Unit vector. Any azimuth; elevations beyond +-90 continue over the pole.
Vec3 vector_of(const AzimuthElevation& angles) noexcept;

/// The inverse; azimuth 0 at the poles and for a zero vector.
AzimuthElevation angles_of(const Vec3& v) noexcept;

}  // namespace hedgehog::model
