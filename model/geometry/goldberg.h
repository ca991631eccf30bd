// SPDX-License-Identifier: MIT
// Goldberg polyhedra GP(m,n) in canonical form: every edge touches the unit sphere and every face
// is planar (G. Hart, "Canonical Polyhedra"). The thesis' tkD array (section 2.2) is GP(3,0), its
// cD GP(2,0) and its wD GP(2,1): a pin per face, a shielding magnet per vertex. Start-up only:
// allocates.
#pragma once

#include <cstddef>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::model {

/// With T = m^2 + m n + n^2: 10 T + 2 faces, 20 T vertices. One pentagon is at +z, another one at
/// -z; the line from the upper one to a neighbouring pentagon is on the meridian of +x.
struct Goldberg {
  struct Face {
    /// Indices of `vertices`, anticlockwise seen from outside; 5 or 6 of them.
    std::vector<std::size_t> corners;
    /// Indices of `faces` that share an edge.
    std::vector<std::size_t> neighbours;
    /// Unit vector towards the mean of the corners.
    Vec3 direction;
    /// Number of edges from the upper pentagon, which has 0.
    int ring = 0;
  };
  std::vector<Vec3> vertices;
  std::vector<Face> faces;
};

/// Maximum m + n.
inline constexpr int kMaxGoldberg = 8;

/// GP(m,n), its angles within 1e-4 degrees of the canonical form. REQUIRES: 1 <= m, 0 <= n,
/// m + n <= kMaxGoldberg.
Goldberg canonical_goldberg(int m, int n = 0);

}  // namespace hedgehog::model
