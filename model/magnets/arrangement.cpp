// SPDX-License-Identifier: MIT
#include "model/magnets/arrangement.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "model/geometry/goldberg.h"

namespace hedgehog::model {
namespace {

/// Heights and directions that differ by less are equal.
constexpr double kSameDirection = 1e-6;

struct GoldbergName {
  int m = 0;
  int n = 0;
};

std::optional<GoldbergName> goldberg_named(std::string_view name) {
  if (name == "D") return GoldbergName{1, 0};
  if (name == "tI") return GoldbergName{1, 1};
  if (name == "cD") return GoldbergName{2, 0};
  if (name == "wD") return GoldbergName{2, 1};
  if (name == "tkD") return GoldbergName{3, 0};
  if (!name.starts_with("GP(") || !name.ends_with(")")) return std::nullopt;
  const char* const end = name.data() + name.size() - 1;
  GoldbergName gp;
  const auto first = std::from_chars(name.data() + 3, end, gp.m);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != ',') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, gp.n);
  if (second.ec != std::errc{} || second.ptr != end) return std::nullopt;
  return gp;
}

double azimuth_from_front(const Vec3& v) {
  const double azimuth = std::atan2(v.y, v.x);
  return azimuth < -kSameDirection ? azimuth + 2.0 * std::numbers::pi : std::max(azimuth, 0.0);
}

/// Sorts by `row`, then anticlockwise from the front, and assigns the ids.
template <typename Row>
void number(std::vector<MagnetSite>& sites, Row row) {
  std::sort(sites.begin(), sites.end(), [&](const MagnetSite& a, const MagnetSite& b) {
    return std::tuple(row(a), azimuth_from_front(a.direction)) <
           std::tuple(row(b), azimuth_from_front(b.direction));
  });
  for (std::size_t i = 0; i < sites.size(); ++i) sites[i].id = static_cast<int>(i);
}

Arrangement arrangement_of(const Goldberg& gp, std::string name) {
  Arrangement arrangement{std::move(name), {}, {}};
  for (const Goldberg::Face& face : gp.faces)
    arrangement.pins.push_back({0, face.direction, face.ring});
  for (const Vec3& vertex : gp.vertices)
    arrangement.shields.push_back({0, unit_or(vertex, {0, 0, 1})});
  number_sites(arrangement);
  return arrangement;
}

/// The tkD array without its bottom pentagon, the five neighbours of that, and the shields that
/// touch at least `touching` of these six faces.
MagnetResult<Arrangement> ball_86(std::string name, std::ptrdiff_t touching) {
  constexpr int kTopRings = 8;
  const Goldberg tkd = canonical_goldberg(3);
  std::vector<Vec3> gone;
  for (std::size_t v = 0; v < tkd.vertices.size(); ++v) {
    const auto touches = [&](const Goldberg::Face& face) {
      return face.ring >= kTopRings && std::count(face.corners.begin(), face.corners.end(), v) > 0;
    };
    if (std::count_if(tkd.faces.begin(), tkd.faces.end(), touches) >= touching)
      gone.push_back(unit_or(tkd.vertices[v], {0, 0, 1}));
  }
  Arrangement ball = arrangement_of(tkd, std::move(name));
  std::vector<int> shields;
  for (const MagnetSite& shield : ball.shields) {
    const auto same = [&](const Vec3& v) { return norm(v - shield.direction) < kSameDirection; };
    if (std::any_of(gone.begin(), gone.end(), same)) shields.push_back(shield.id);
  }
  const std::vector<int> pins{86, 87, 88, 89, 90, 91};
  return without(std::move(ball), pins, shields);
}

std::optional<MagnetError> remove(std::vector<MagnetSite>& sites, std::span<const int> ids,
                                  std::string_view what, GeometryPart part) {
  for (auto at = ids.begin(); at != ids.end(); ++at) {
    const int id = *at;
    const auto found = std::find_if(sites.begin(), sites.end(),
                                    [&](const MagnetSite& site) { return site.id == id; });
    if (found == sites.end()) {
      const std::string named = std::string(what) + ' ' + std::to_string(id);
      const bool again = std::find(ids.begin(), at, id) != at;
      return MagnetError{
          again ? named + " is removed twice" : "there is no " + named + " to remove", part};
    }
    sites.erase(found);
  }
  return std::nullopt;
}

}  // namespace

MagnetResult<Arrangement> arrangement_named(std::string_view name) {
  if (name == "tkD-86") return ball_86(std::string(name), 2);
  if (name == "tkD-86-5") return ball_86(std::string(name), 3);
  if (name == "tkD-86-20") return ball_86(std::string(name), 1);
  const auto gp = goldberg_named(name);
  if (!gp) {
    return MagnetError{"unknown array '" + std::string(name) +
                       "': known are cD, wD, tkD, D, tI, GP(m,n), tkD-86, tkD-86-5 and tkD-86-20"};
  }
  if (gp->m < 1 || gp->n < 0 || gp->m > kMaxGoldberg || gp->n > kMaxGoldberg - gp->m) {
    return MagnetError{"array '" + std::string(name) +
                       "': m must be at least 1, n at least 0 and " + "m + n at most " +
                       std::to_string(kMaxGoldberg)};
  }
  return arrangement_of(canonical_goldberg(gp->m, gp->n), std::string(name));
}

MagnetResult<Arrangement> without(Arrangement arrangement, std::span<const int> pins,
                                  std::span<const int> shields) {
  if (auto error = remove(arrangement.pins, pins, "pin", GeometryPart::kRemovedPins)) return *error;
  if (auto error = remove(arrangement.shields, shields, "shield", GeometryPart::kRemovedShields))
    return *error;
  return arrangement;
}

void number_sites(Arrangement& arrangement) {
  number(
      arrangement.pins, [](const MagnetSite& site) { return site.ring; });
  number(arrangement.shields,
         [](const MagnetSite& site) { return std::lround(-site.direction.z / kSameDirection); });
}

double angle_deg(const Vec3& a, const Vec3& b) noexcept {
  return std::atan2(norm(cross(a, b)), dot(a, b)) * 180.0 / std::numbers::pi;
}

}  // namespace hedgehog::model
