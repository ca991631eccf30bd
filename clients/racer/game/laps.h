// SPDX-License-Identifier: MIT
// Progress of the car along the track.
#pragma once

#include <cstddef>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::racer {

/// The point of the closed line `centre` that is nearest to `position`. REQUIRES: not empty.
std::size_t nearest_point(const std::vector<model::Vec3>& centre, const model::Vec3& position);

/// Counts the distance along the line, so that cutting across or driving backwards makes no lap. A
/// lap ends at the first point, where the next one begins, whether or not it counted.
class Laps {
 public:
  /// True if `position` has just completed a lap.
  bool take(const std::vector<model::Vec3>& centre, const model::Vec3& position);
  int done() const noexcept { return done_; }

 private:
  std::size_t point_ = 0;
  long way_ = 0;  // points since the line, forward less backward
  int done_ = 0;
};

}  // namespace hedgehog::racer
