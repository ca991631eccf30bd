// SPDX-License-Identifier: MIT
#include "model/magnets/pair/pair_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/magnets/pair/face_flux.h"
#include "model/units.h"

namespace hedgehog::model {
namespace {

/// Point in the plane of both axes, z along the other's axis.
struct Point {
  double x = 0.0;
  double z = 0.0;
};

constexpr Point operator-(Point a, Point b) noexcept { return {a.x - b.x, a.z - b.z}; }
constexpr double dot(Point a, Point b) noexcept { return a.x * b.x + a.z * b.z; }

double dipole_force_n(const MagnetPair& pair, const PairPlace& place) noexcept {
  const double sine = std::sin(place.angle_deg * kRadiansPerDegree);
  const double cosine = std::cos(place.angle_deg * kRadiansPerDegree);
  const auto middle_m = [&](const CylinderMagnet& magnet, double offset_mm) {
    return 1e-3 * (pair.sphere_radius_mm + offset_mm + 0.5 * magnet.height_mm);
  };
  const double subject_m = middle_m(pair.subject, place.offset_mm);
  const double other_m = middle_m(pair.other, place.other_offset_mm);
  const Point between{subject_m * sine, subject_m * cosine - other_m};
  const double r2 = dot(between, between);
  const double r = std::sqrt(r2);
  // Cosines of the angles between the connecting line and each axis.
  const double along_subject = dot(between, {sine, cosine}) / r;
  const double along_other = between.z / r;
  const double shape = along_subject * cosine + along_other + cosine * along_subject -
                       5.0 * along_subject * along_other * along_subject;
  // mu0 / 4 pi = 1e-7.
  return 3e-7 * moment_a_m2(pair.subject) * moment_a_m2(pair.other) / (r2 * r2) * shape;
}

PairForce exact_force(const MagnetPair& pair, const PairPlace& place, double accuracy) noexcept {
  const FaceFlux flux(pair, place.angle_deg, place.other_offset_mm);
  const double bottom_mm = pair.sphere_radius_mm + place.offset_mm;
  const double top_mm = bottom_mm + pair.subject.height_mm;
  FaceForce bottom = flux.first(bottom_mm, accuracy);
  FaceForce top = flux.first(top_mm, accuracy);
  return settle(flux, bottom_mm, bottom, top_mm, top, accuracy);
}

/// Cross-section of a magnet in the plane, anticlockwise.
std::array<Point, 4> outline(const CylinderMagnet& magnet, double inner_mm, double angle) noexcept {
  const Point axis{std::sin(angle), std::cos(angle)};
  const Point side{std::cos(angle), -std::sin(angle)};
  const double outer_mm = inner_mm + magnet.height_mm;
  const auto corner = [&](double across, double along) {
    return Point{across * side.x + along * axis.x, across * side.z + along * axis.z};
  };
  const double r = magnet.radius_mm();
  return {corner(-r, inner_mm), corner(r, inner_mm), corner(r, outer_mm), corner(-r, outer_mm)};
}

double distance(Point p, Point a, Point b) noexcept {
  const Point along = b - a;
  const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  const Point off = p - Point{a.x + t * along.x, a.z + t * along.z};
  return std::sqrt(dot(off, off));
}

/// Maximum separation of `b` from a side of `a`; negative if no side separates them.
double separation(const std::array<Point, 4>& a, const std::array<Point, 4>& b) noexcept {
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i) {
    const Point along = a[(i + 1) % 4] - a[i];
    const double length = std::sqrt(dot(along, along));
    const Point outward{along.z / length, -along.x / length};
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& corner : b) nearest = std::min(nearest, dot(corner - a[i], outward));
    best = std::max(best, nearest);
  }
  return best;
}

}  // namespace

std::string_view name_of(ForceModel model) noexcept {
  switch (model) {
    case ForceModel::kExact:
      return "exact";
    case ForceModel::kHybrid:
      return "hybrid";
    case ForceModel::kDipole:
      return "dipole";
  }
  return "";
}

std::optional<ForceModel> force_model_named(std::string_view name) noexcept {
  for (const ForceModel model : {ForceModel::kExact, ForceModel::kHybrid, ForceModel::kDipole})
    if (name == name_of(model)) return model;
  return std::nullopt;
}

PairForce pair_force(const MagnetPair& pair, const PairPlace& place,
                     const ForceSettings& settings) noexcept {
  if (takes_dipoles(settings.model, place.angle_deg)) return {dipole_force_n(pair, place), 0.0};
  return exact_force(pair, place, clamped(settings.accuracy));
}

double gap_mm(const MagnetPair& pair, const PairPlace& place) noexcept {
  const auto subject = outline(pair.subject, pair.sphere_radius_mm + place.offset_mm,
                               place.angle_deg * kRadiansPerDegree);
  const auto other = outline(pair.other, pair.sphere_radius_mm + place.other_offset_mm, 0.0);
  const double apart = std::max(separation(subject, other), separation(other, subject));
  if (apart <= 0.0) return apart;
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      gap = std::min({gap, distance(subject[i], other[k], other[(k + 1) % 4]),
                      distance(other[i], subject[k], subject[(k + 1) % 4])});
    }
  }
  return gap;
}

}  // namespace hedgehog::model
