// SPDX-License-Identifier: MIT
#include "model/geometry/goldberg.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "model/geometry/geodesic.h"

namespace hedgehog::model {
namespace {

/// Orders the corners of `face` anticlockwise about `outward`.
void sort_corners(Goldberg::Face& face, const std::vector<Vec3>& vertices, const Vec3& outward) {
  const Vec3 u = unit_or(cross(outward, vertices[face.corners.front()]), {1, 0, 0});
  const Vec3 v = cross(outward, u);
  const auto angle = [&](std::size_t i) {
    return std::atan2(dot(vertices[i], v), dot(vertices[i], u));
  };
  std::sort(face.corners.begin(), face.corners.end(),
            [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
}

Goldberg dual_of(const Geodesic& fine) {
  Goldberg gp;
  gp.faces.resize(fine.points.size());
  for (std::size_t i = 0; i < fine.triangles.size(); ++i) {
    const auto& t = fine.triangles[i];
    const Vec3 sum = fine.points[t[0]] + fine.points[t[1]] + fine.points[t[2]];
    gp.vertices.push_back(unit_or(sum, {0, 0, 1}));
    for (std::size_t k = 0; k < 3; ++k) {
      Goldberg::Face& face = gp.faces[t[k]];
      face.corners.push_back(i);
      // Each neighbour occurs twice, once in each sense of rotation; one sense lists it once.
      face.neighbours.push_back(t[(k + 1) % 3]);
    }
  }
  for (std::size_t f = 0; f < gp.faces.size(); ++f)
    sort_corners(gp.faces[f], gp.vertices, fine.points[f]);
  return gp;
}

std::vector<std::array<std::size_t, 2>> edges_of(const Goldberg& gp) {
  std::vector<std::array<std::size_t, 2>> edges;
  for (const Goldberg::Face& face : gp.faces) {
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
      const std::size_t a = face.corners[k];
      const std::size_t b = face.corners[(k + 1) % face.corners.size()];
      if (a < b) edges.push_back({a, b});
    }
  }
  return edges;
}

Vec3 mean_of(const std::vector<std::size_t>& corners, const std::vector<Vec3>& vertices) {
  Vec3 sum;
  for (const std::size_t i : corners) sum = sum + vertices[i];
  return (1.0 / static_cast<double>(corners.size())) * sum;
}

using Steps = std::vector<Vec3>;

/// Moves `vertices` by `steps` and clears these.
void apply(Steps& steps, std::vector<Vec3>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i] = vertices[i] + steps[i];
    steps[i] = {};
  }
}

void step_to_planes(const Goldberg& gp, double part, Steps& steps) {
  for (const Goldberg::Face& face : gp.faces) {
    Vec3 normal;
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
      const std::size_t next = face.corners[(k + 1) % face.corners.size()];
      normal = normal + cross(gp.vertices[face.corners[k]], gp.vertices[next]);
    }
    normal = unit_or(normal, {0, 0, 1});
    const Vec3 centre = mean_of(face.corners, gp.vertices);
    for (const std::size_t i : face.corners)
      steps[i] = steps[i] + (part * dot(normal, centre - gp.vertices[i])) * normal;
  }
}

/// Alternating projections: edges towards tangency, then faces towards planes. All steps of a half
/// sweep are applied at once; sequential steps would shift the polyhedron off centre (the canonical
/// form is unique only up to Moebius maps; the symmetry selects the centred one). Momentum from the
/// previous sweep reduces the number of sweeps to a seventh.
void make_canonical(Goldberg& gp) {
  constexpr double kTangency = 0.6;
  constexpr double kPlanarity = 0.4;
  constexpr double kMomentum = 0.85;
  constexpr int kMaxSweeps = 20'000;
  constexpr double kSettled = 1e-10;
  const auto edges = edges_of(gp);
  Steps steps(gp.vertices.size());
  Steps moved(gp.vertices.size());
  std::vector<Vec3> before;
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    before = gp.vertices;
    for (const auto& [a, b] : edges) {
      const Vec3 along = gp.vertices[b] - gp.vertices[a];
      const double t = -dot(gp.vertices[a], along) / dot(along, along);
      const Vec3 nearest = gp.vertices[a] + t * along;
      const double distance = norm(nearest);
      const Vec3 step = (kTangency * (1.0 - distance) / distance) * nearest;
      steps[a] = steps[a] + step;
      steps[b] = steps[b] + step;
    }
    apply(steps, gp.vertices);
    step_to_planes(gp, kPlanarity, steps);
    apply(steps, gp.vertices);
    double longest = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      moved[i] = (gp.vertices[i] - before[i]) + kMomentum * moved[i];
      gp.vertices[i] = before[i] + moved[i];
      longest = std::max(longest, norm(moved[i]));
    }
    if (longest < kSettled) return;
  }
}

void number_rings(Goldberg& gp) {
  const auto top =
      std::max_element(gp.faces.begin(), gp.faces.end(),
                       [](const auto& a, const auto& b) { return a.direction.z < b.direction.z; });
  std::vector<std::size_t> reached{static_cast<std::size_t>(top - gp.faces.begin())};
  std::vector<bool> seen(gp.faces.size(), false);
  seen[reached.front()] = true;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const Goldberg::Face& face = gp.faces[reached[next]];
    for (const std::size_t n : face.neighbours) {
      if (seen[n]) continue;
      seen[n] = true;
      gp.faces[n].ring = face.ring + 1;
      reached.push_back(n);
    }
  }
}

}  // namespace

Goldberg canonical_goldberg(int m, int n) {
  assert(m >= 1 && n >= 0 && m + n <= kMaxGoldberg);
  Goldberg gp = dual_of(geodesic(m, n));
  make_canonical(gp);
  for (Goldberg::Face& face : gp.faces)
    face.direction = unit_or(mean_of(face.corners, gp.vertices), {0, 0, 1});
  number_rings(gp);
  return gp;
}

}  // namespace hedgehog::model
