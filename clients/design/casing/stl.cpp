// SPDX-License-Identifier: MIT
#include "clients/design/casing/stl.h"

#include <array>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::design {
namespace {

using model::Vec3;

/// Indices of points: equal text is the same corner.
class Corners {
 public:
  std::size_t number_of(const std::string& x, const std::string& y, const std::string& z) {
    const auto [found, is_new] = numbers_.try_emplace(x + " " + y + " " + z, points_.size());
    if (is_new) points_.push_back({std::stod(x), std::stod(y), std::stod(z)});
    return found->second;
  }
  const Vec3& at(std::size_t number) const { return points_[number]; }

 private:
  std::map<std::string, std::size_t> numbers_;
  std::vector<Vec3> points_;
};

}  // namespace

Result<Surface> check_stl(const std::string& text) {
  if (!text.starts_with("solid")) return Problem{kBadData, "is not an STL in text form"};
  Surface surface;
  Corners corners;
  // For each edge, from the lower to the higher corner: the counts of both directions.
  std::map<std::pair<std::size_t, std::size_t>, std::array<int, 2>> edges;
  std::array<std::size_t, 3> triangle{};
  std::size_t seen = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word != "vertex") continue;
    std::string x;
    std::string y;
    std::string z;
    if (!(words >> x >> y >> z)) return Problem{kBadData, "ends within a triangle"};
    triangle[seen++ % 3] = corners.number_of(x, y, z);
    if (seen % 3 != 0) continue;
    const auto [a, b, c] = triangle;
    // Degenerate after rounding: without area, its edges coincide.
    if (a == b || b == c || c == a) continue;
    ++surface.triangles;
    surface.volume_mm3 +=
        model::dot(corners.at(a), model::cross(corners.at(b), corners.at(c))) / 6.0;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      ++edges[std::minmax(from, to)][from < to ? 0 : 1];
  }
  if (seen == 0 || seen % 3 != 0) return Problem{kBadData, "has no whole triangles"};
  for (const auto& [edge, ways] : edges)
    if (ways[0] != 1 || ways[1] != 1) ++surface.open_edges;
  return surface;
}

}  // namespace hedgehog::design
