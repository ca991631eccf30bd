// SPDX-License-Identifier: MIT
#include "clients/racer/game/laps.h"

namespace hedgehog::racer {

std::size_t nearest_point(const std::vector<model::Vec3>& centre, const model::Vec3& position) {
  std::size_t best = 0;
  double best_square = -1.0;
  for (std::size_t i = 0; i < centre.size(); ++i) {
    const model::Vec3 away{centre[i].x - position.x, centre[i].y - position.y, 0.0};
    const double square = dot(away, away);
    if (best_square < 0.0 || square < best_square) {
      best = i;
      best_square = square;
    }
  }
  return best;
}

bool Laps::take(const std::vector<model::Vec3>& centre, const model::Vec3& position) {
  if (centre.empty()) return false;
  const long count = static_cast<long>(centre.size());
  const std::size_t now = nearest_point(centre, position);
  long moved = static_cast<long>(now) - static_cast<long>(point_);
  if (moved > count / 2) moved -= count;
  if (moved < -count / 2) moved += count;
  const bool over_the_line = static_cast<long>(point_) + moved >= count;
  point_ = now;
  // A jump across the infield does not count.
  constexpr long kMaxMoved = 8;
  if (moved <= kMaxMoved && moved >= -kMaxMoved) way_ += moved;
  if (!over_the_line) return false;
  const bool whole = way_ >= count;
  way_ = static_cast<long>(now);
  if (whole) ++done_;
  return whole;
}

}  // namespace hedgehog::racer
