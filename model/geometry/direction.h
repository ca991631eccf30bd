// SPDX-License-Identifier: MIT
// Directions by name, by angles and by pin. They say where the pins push out ("towards"), never
// where a force comes from. Frame: x front, y left, z up; right-handed (REP-103).
#pragma once

#include <array>
#include <string_view>

#include "model/vec3.h"

namespace hedgehog::model {

struct NamedDirection {
  std::string_view name;
  Vec3 vector;
};

/// The six words of the protocol.
inline constexpr std::array<NamedDirection, 6> kNamedDirections{{
    {"up", {0, 0, 1}},
    {"down", {0, 0, -1}},
    {"left", {0, 1, 0}},
    {"right", {0, -1, 0}},
    {"front", {1, 0, 0}},
    {"back", {-1, 0, 0}},
}};

/// The word nearest to `v`; "up" for a vector of no length. What a person is told: "at pin 34, on
/// the left".
std::string_view side_name(const Vec3& v) noexcept;

/// Degrees. Azimuth anticlockwise seen from above, 0 front, 90 left, -180..180; elevation from the
/// horizon, 90 up, -90..90.
struct AzimuthElevation {
  double azimuth_deg = 0.0;
  double elevation_deg = 0.0;
};

/// A unit vector. Any azimuth; elevations beyond +-90 go on over the pole.
Vec3 vector_of(const AzimuthElevation& angles) noexcept;

/// The inverse; azimuth 0 at the poles and for a vector of no length.
AzimuthElevation angles_of(const Vec3& v) noexcept;

}  // namespace hedgehog::model
