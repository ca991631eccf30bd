// SPDX-License-Identifier: MIT
// Geodesic triangulations of the sphere by Caspar and Klug: an icosahedron subdivided by the
// triangular lattice in which each side is m steps along one direction and n along the next. The
// dual is the Goldberg polyhedron GP(m,n). Start-up only: allocates.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::model {

struct Geodesic {
  /// 10 (m^2 + m n + n^2) + 2 unit vectors.
  std::vector<Vec3> points;
  /// Indices of `points`, anticlockwise seen from outside.
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// A corner of the icosahedron is at +z and its neighbour on the meridian of +x. (m,n) and (n,m)
/// are distinct mirror images. REQUIRES: m >= 1, n >= 0.
Geodesic geodesic(int m, int n);

}  // namespace hedgehog::model
