// SPDX-License-Identifier: MIT
#include "tests/model/magnets/placed_magnet.h"

#include <cmath>
#include <numbers>

#include "model/magnets/pair/disk_rule.h"

namespace hedgehog::model {

Vec3 field_at(const PlacedMagnet& magnet, const Vec3& point_mm) noexcept {
  const Vec3 r = point_mm - magnet.centre_mm;
  const double z = dot(r, magnet.axis);
  const Vec3 across = r - z * magnet.axis;
  const double rho = norm(across);
  const AxialField field = field_of(magnet.magnet, rho, z);
  const Vec3 axial = field.axial_t * magnet.axis;
  return rho > 0.0 ? axial + (field.radial_t / rho) * across : axial;
}

Vec3 force_between(const PlacedMagnet& subject, const PlacedMagnet& other, int order) noexcept {
  const DiskRule& rule = disk_rule(order);
  const auto radii = static_cast<std::size_t>(order);
  const double radius = subject.magnet.radius_mm();
  const Vec3 away = std::abs(subject.axis.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 u = unit_or(cross(subject.axis, away), {1, 0, 0});
  const Vec3 v = cross(subject.axis, u);
  Vec3 sum;
  for (const double face : {1.0, -1.0}) {
    const Vec3 centre = subject.centre_mm + (0.5 * face * subject.magnet.height_mm) * subject.axis;
    for (std::size_t i = 0; i < radii; ++i) {
      for (std::size_t j = 0; j < 2 * radii; ++j) {
        const Vec3 along = (radius * rule.radius[i] * rule.cosine[j]) * u;
        const Vec3 beside = (radius * rule.radius[i] * rule.sine[j]) * v;
        const Vec3 both =
            field_at(other, centre + along + beside) + field_at(other, centre + along - beside);
        sum = sum + (face * rule.weight[i]) * both;
      }
    }
  }
  const double area_m2 = std::numbers::pi * radius * radius * 1e-6;
  return (subject.magnet.remanence_t / kVacuumPermeability * area_m2 / (4.0 * order)) * sum;
}

}  // namespace hedgehog::model
