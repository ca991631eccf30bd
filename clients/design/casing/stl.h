// SPDX-License-Identifier: MIT
// Check that a surface is closed, as required for printing: each edge of a triangle must be shared
// with exactly one other triangle, in the opposite direction.
#pragma once

#include <cstddef>
#include <string>

#include "clients/common/problem.h"

namespace hedgehog::design {

struct Surface {
  std::size_t triangles = 0;
  /// Edges that are not shared with exactly one other triangle. 0: closed, and no edge belongs to
  /// more than two.
  std::size_t open_edges = 0;
  /// Enclosed volume, mm^3; positive if the triangles face outwards.
  double volume_mm3 = 0.0;
};

/// Parses an STL in text form.
Result<Surface> check_stl(const std::string& text);

}  // namespace hedgehog::design
