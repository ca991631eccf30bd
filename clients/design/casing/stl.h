// SPDX-License-Identifier: MIT
// Is a surface closed? A printer needs it to be: each edge of a triangle must be met by exactly one
// other triangle, in the other direction.
#pragma once

#include <cstddef>
#include <string>

#include "clients/common/problem.h"

namespace hedgehog::design {

struct Surface {
  std::size_t triangles = 0;
  /// Edges that are not met by exactly one other. 0: closed, and no edge belongs to more than two.
  std::size_t open_edges = 0;
  /// What it encloses, mm^3; positive when the triangles look outwards.
  double volume_mm3 = 0.0;
};

/// Reads an STL in its text form.
Result<Surface> check_stl(const std::string& text);

}  // namespace hedgehog::design
