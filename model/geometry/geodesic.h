// SPDX-License-Identifier: MIT
// Geodesic triangulations of the sphere by Caspar and Klug: an icosahedron whose side is m steps of
// a triangular lattice along one direction and n along the next. Start-up only: allocates.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::model {

/// The dual is the Goldberg polyhedron GP(m,n).
struct Geodesic {
  std::vector<Vec3> points;                           // 10 (m^2 + m n + n^2) + 2 unit vectors
  std::vector<std::array<std::size_t, 3>> triangles;  // of `points`, anticlockwise from outside
};

/// A corner of the icosahedron is at +z and its neighbour on the meridian of +x. (m,n) and (n,m)
/// are distinct mirror images. REQUIRES: m >= 1, n >= 0.
Geodesic geodesic(int m, int n);

}  // namespace hedgehog::model
