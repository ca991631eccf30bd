// SPDX-License-Identifier: MIT
// Directions of pins and shields from the centre, independent of all sizes: a pin in each face of a
// Goldberg polyhedron, a shield at each vertex (thesis section 2.1). Start-up only: allocates.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/magnets/magnet_error.h"
#include "model/vec3.h"

namespace hedgehog::model {

struct MagnetSite {
  int id = 0;      // kept when other sites are removed
  Vec3 direction;  // unit vector
  int ring = 0;    // pins: number of faces from the top one, which has 0; shields: unused
};

struct Arrangement {
  std::string name;  // "tkD", "GP(4,1)", "tkD-86", ...
  std::vector<MagnetSite> pins;
  std::vector<MagnetSite> shields;
};

/// "D" = GP(1,0) (12 faces), "tI" = GP(1,1) (32), "cD" = GP(2,0) (42), "wD" = GP(2,1) (72), "tkD" =
/// GP(3,0) (92), any "GP(m,n)" with 1 <= m, 0 <= n, m + n <= 8, and the thesis' ball: "tkD-86"
/// without the 10 shields that touch two or three of its removed faces; "tkD-86-5": three,
/// "tkD-86-20": any (reference: physics.md section 4). A pentagon is on top; the thesis' pins are
/// numbered as in `thesis_ball`, others from the top down, anticlockwise from the front at each
/// height. Not cached (tkD 10 ms, GP(8,0) about a second): keep the value.
MagnetResult<Arrangement> arrangement_named(std::string_view name);

/// An unknown id is an error.
MagnetResult<Arrangement> without(Arrangement arrangement, std::span<const int> pins,
                                  std::span<const int> shields);

/// Numbers pins ring by ring from the top, shields by height, each anticlockwise from the front.
void number_sites(Arrangement& arrangement);

/// Exact for small angles too.
double angle_deg(const Vec3& a, const Vec3& b) noexcept;

}  // namespace hedgehog::model
