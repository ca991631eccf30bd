// SPDX-License-Identifier: MIT
#include "model/geometry/geodesic.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <set>

namespace hedgehog::model {
namespace {

using Triangle = std::array<std::size_t, 3>;

/// Points closer than this are equal but for rounding; distinct points are farther apart.
constexpr double kSamePoint = 1e-6;

Geodesic icosahedron() {
  Geodesic ico;
  const double z = 1.0 / std::sqrt(5.0);
  const double r = 2.0 * z;
  const auto at = [&](double height, double turns) {
    const double azimuth = turns * std::numbers::pi / 5.0;
    return Vec3{r * std::cos(azimuth), r * std::sin(azimuth), height};
  };
  ico.points.push_back({0, 0, 1});
  for (int i = 0; i < 5; ++i) ico.points.push_back(at(z, 2.0 * i));
  for (int i = 0; i < 5; ++i) ico.points.push_back(at(-z, 2.0 * i + 1.0));
  ico.points.push_back({0, 0, -1});
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t upper = 1 + i;
    const std::size_t next_upper = 1 + (i + 1) % 5;
    const std::size_t lower = 6 + i;
    const std::size_t next_lower = 6 + (i + 1) % 5;
    ico.triangles.push_back({0, upper, next_upper});
    ico.triangles.push_back({upper, lower, next_upper});
    ico.triangles.push_back({next_upper, lower, next_lower});
    ico.triangles.push_back({lower, 11, next_lower});
  }
  return ico;
}

/// Index of `p` in `points`; appends it if new. Adjacent triangles yield the same points on their
/// common side except for rounding.
std::size_t index_of(std::vector<Vec3>& points, const Vec3& p) {
  const auto same = [&](const Vec3& q) { return norm(q - p) < kSamePoint; };
  const auto found = std::find_if(points.begin(), points.end(), same);
  if (found == points.end()) {
    points.push_back(p);
    return points.size() - 1;
  }
  return static_cast<std::size_t>(found - points.begin());
}

/// i steps along one direction of the lattice and j along the one at 60 degrees to it.
struct Step {
  int i = 0;
  int j = 0;
};

constexpr Step operator+(Step a, Step b) noexcept { return {a.i + b.i, a.j + b.j}; }

/// Barycentric coordinates in a triangle of the icosahedron.
using Weights = std::array<double, 3>;

/// One triangle of the icosahedron; `beyond[k]` is the far corner of the neighbour opposite
/// `corner[k]`.
struct Patch {
  std::array<Vec3, 3> corner;
  std::array<Vec3, 3> beyond;
};

Patch patch_of(const Geodesic& ico, const Triangle& t) {
  Patch patch;
  for (std::size_t k = 0; k < 3; ++k) {
    patch.corner[k] = ico.points[t[k]];
    const std::size_t a = t[(k + 1) % 3];
    const std::size_t b = t[(k + 2) % 3];
    for (const Triangle& other : ico.triangles) {
      const bool shares = std::count(other.begin(), other.end(), a) == 1 &&
                          std::count(other.begin(), other.end(), b) == 1;
      if (!shares || std::count(other.begin(), other.end(), t[k]) == 1) continue;
      for (const std::size_t far : other)
        if (far != a && far != b) patch.beyond[k] = ico.points[far];
    }
  }
  return patch;
}

/// A lattice triangle crosses at most one side, so a negative weight refers to the neighbour there:
/// unfolded, its far corner is the mirror image of this triangle's.
Vec3 place(const Patch& patch, Weights weights) {
  std::array<Vec3, 3> corner = patch.corner;
  for (std::size_t k = 0; k < 3; ++k) {
    if (weights[k] > -kSamePoint) continue;
    const double over = weights[k];
    weights[(k + 1) % 3] += over;
    weights[(k + 2) % 3] += over;
    weights[k] = -over;
    corner[k] = patch.beyond[k];
    break;
  }
  return weights[0] * corner[0] + weights[1] * corner[1] + weights[2] * corner[2];
}

}  // namespace

Geodesic geodesic(int m, int n) {
  assert(m >= 1 && n >= 0);
  const Geodesic ico = icosahedron();
  Geodesic fine;
  std::set<Triangle> known;
  const double area = m * m + m * n + n * n;
  // The corners are at (0,0), (m,n) and that turned by 60 degrees, (-n, m+n).
  const auto weights = [&](double i, double j) {
    const double b = (i * (m + n) + j * n) / area;
    const double c = (j * m - i * n) / area;
    return Weights{1.0 - b - c, b, c};
  };
  const std::array<std::array<Step, 3>, 2> kinds{
      {{{{0, 0}, {1, 0}, {0, 1}}}, {{{1, 0}, {1, 1}, {0, 1}}}}};
  for (const Triangle& t : ico.triangles) {
    const Patch patch = patch_of(ico, t);
    for (int i = -n - 1; i <= m; ++i) {
      for (int j = -1; j <= m + n; ++j) {
        for (const auto& kind : kinds) {
          Triangle indices{};
          const Step sum = kind[0] + kind[1] + kind[2];
          const Weights middle = weights(i + sum.i / 3.0, j + sum.j / 3.0);
          // A triangle whose middle lies on a side occurs in both; `known` keeps it once.
          if (*std::min_element(middle.begin(), middle.end()) < -kSamePoint) continue;
          for (std::size_t k = 0; k < 3; ++k) {
            const Weights w = weights(i + kind[k].i, j + kind[k].j);
            indices[k] = index_of(fine.points, place(patch, w));
          }
          Triangle sorted = indices;
          std::sort(sorted.begin(), sorted.end());
          if (known.insert(sorted).second) fine.triangles.push_back(indices);
        }
      }
    }
  }
  for (Vec3& p : fine.points) p = unit_or(p, {0, 0, 1});
  return fine;
}

}  // namespace hedgehog::model
