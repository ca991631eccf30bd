// SPDX-License-Identifier: MIT
// Goldberg polyhedra GP(m,n) in canonical form: every edge touches the unit sphere and every face
// is planar (G. Hart, "Canonical Polyhedra"; thesis section 2.2). Start-up only: allocates.
#pragma once

#include <cstddef>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::model {

/// With T = m^2 + m n + n^2: 10 T + 2 faces, 20 T vertices. One pentagon is at +z, another one at
/// -z; the line from the upper one to a neighbouring pentagon is on the meridian of +x.
struct Goldberg {
  struct Face {
    std::vector<std::size_t> corners;     // 5 or 6 of `vertices`, anticlockwise seen from outside
    std::vector<std::size_t> neighbours;  // those of `faces` that share an edge
    Vec3 direction;                       // unit vector towards the mean of the corners
    int ring = 0;                         // number of edges from the upper pentagon, which has 0
  };
  std::vector<Vec3> vertices;
  std::vector<Face> faces;
};

inline constexpr int kMaxGoldberg = 8;  // m + n

/// Angles are exact within 1e-4 degrees. REQUIRES: 1 <= m, 0 <= n, m + n <= kMaxGoldberg.
Goldberg canonical_goldberg(int m, int n = 0);

}  // namespace hedgehog::model
