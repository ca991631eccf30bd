// SPDX-License-Identifier: MIT
// Goldberg polyhedra GP(n,0) in canonical form: every edge touches the unit sphere and every face
// is plane (G. Hart, "Canonical Polyhedra"). The thesis' tkD array (section 2.2) is GP(3,0): a pin
// per face, a shielding magnet per vertex. Start-up only: allocates.
#pragma once

#include <cstddef>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::model {

/// 10 n^2 + 2 faces, 20 n^2 vertices. A pentagon points to +z and another one to -z; the line from
/// the upper one to a neighbouring pentagon runs down the meridian of +x.
struct Goldberg {
  struct Face {
    /// Indices of `vertices`, anticlockwise seen from outside; 5 or 6 of them.
    std::vector<std::size_t> corners;
    /// Indices of `faces` that share an edge.
    std::vector<std::size_t> neighbours;
    /// Unit vector towards the mean of the corners.
    Vec3 direction;
    /// Edges to be crossed from the upper pentagon, which has 0.
    int ring = 0;
  };
  std::vector<Vec3> vertices;
  std::vector<Face> faces;
};

/// GP(n,0), its angles within 1e-4 degrees of the canonical form. REQUIRES: 1 <= n <= 8.
Goldberg canonical_goldberg(int n);

}  // namespace hedgehog::model
