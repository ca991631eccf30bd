// SPDX-License-Identifier: MIT
// Positions of pins and shields, as directions from the centre: a pin in each face of a Goldberg
// polyhedron and a shield at each vertex (thesis section 2.1), except those removed. Independent of
// all sizes. Start-up and design time only: allocates.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/magnets/magnet_error.h"
#include "model/vec3.h"

namespace hedgehog::model {

/// A site keeps its id when others are removed, so that ids stay unambiguous.
struct MagnetSite {
  int id = 0;
  /// Length 1.
  Vec3 direction;
  /// Pins: number of faces from the top one, which has 0. Shields: unused.
  int ring = 0;
};

struct Arrangement {
  /// "tkD", "GP(4,1)", "tkD-86", ...
  std::string name;
  std::vector<MagnetSite> pins;
  std::vector<MagnetSite> shields;
};

/// "D" (the dodecahedron, 12 faces, GP(1,0)), "tI" (32, GP(1,1)), "cD" (42 faces, GP(2,0)), "wD"
/// (72, GP(2,1)), "tkD" (92, GP(3,0)), any "GP(m,n)" with 1 <= m, 0 <= n, m + n <= 8, and the ball
/// of the thesis: "tkD-86" with the 10 shields removed that touch two or three of its removed
/// faces, "tkD-86-5" and "tkD-86-20" with those that touch three and one (reference: physics.md
/// section 4). A pentagon is on top; pins of the thesis' balls are numbered as in `thesis_ball`,
/// others from the top down, anticlockwise from the front at each height. Not cached (tkD 10 ms,
/// GP(8,0) about a second): keep the value.
MagnetResult<Arrangement> arrangement_named(std::string_view name);

/// `arrangement` without the pins and shields with these ids; an unknown id is an error.
MagnetResult<Arrangement> without(Arrangement arrangement, std::span<const int> pins,
                                  std::span<const int> shields);

/// Numbers pins ring by ring from the top, shields by height, each anticlockwise from the front.
void number_sites(Arrangement& arrangement);

/// Angle between two directions, degrees; exact for small ones too.
double angle_deg(const Vec3& a, const Vec3& b) noexcept;

}  // namespace hedgehog::model
