// SPDX-License-Identifier: MIT
#include "model/magnets/magnet_array.h"

#include <fmt/format.h>

namespace hedgehog::model {
namespace {

constexpr double kMaxSphereRadiusMm = 1000.0;

/// The gap with the smallest angle, which for equal sizes is the smallest gap.
std::optional<MagnetGap> nearest(const std::vector<MagnetSite>& a, MagnetKind kind_a,
                                 const std::vector<MagnetSite>& b, MagnetKind kind_b,
                                 const MagnetPair& pair) {
  std::optional<MagnetGap> best;
  double best_cosine = -2.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = kind_a == kind_b ? i + 1 : 0; k < b.size(); ++k) {
      const double cosine = dot(a[i].direction, b[k].direction);
      // The margin keeps rounding from deciding between equal angles.
      if (cosine <= best_cosine + 1e-9) continue;
      best_cosine = cosine;
      best = MagnetGap{kind_a, a[i].id, kind_b, b[k].id, angle_deg(a[i].direction, b[k].direction),
                       0.0};
    }
  }
  if (best) best->gap_mm = gap_mm(pair, {best->angle_deg, 0.0, 0.0});
  return best;
}

}  // namespace

std::string_view name_of(MagnetKind kind) noexcept {
  return kind == MagnetKind::kPin ? "pin" : "shield";
}

std::optional<std::string> problem_with(const ArraySizes& sizes) {
  if (auto problem = problem_with(sizes.pin, "the pin")) return problem;
  if (auto problem = problem_with(sizes.shield, "the shield")) return problem;
  if (!(sizes.sphere_radius_mm > 0.0 && sizes.sphere_radius_mm <= kMaxSphereRadiusMm))
    return "the radius of the sphere must be above 0 and at most 1 m";
  return std::nullopt;
}

std::vector<MagnetGap> smallest_gaps(const Arrangement& arrangement, const ArraySizes& sizes) {
  const auto& pins = arrangement.pins;
  const auto& shields = arrangement.shields;
  constexpr MagnetKind kPin = MagnetKind::kPin;
  constexpr MagnetKind kShield = MagnetKind::kShield;
  std::vector<MagnetGap> gaps;
  for (const auto& gap : {nearest(pins, kPin, pins, kPin, sizes.pin_and_pin()),
                          nearest(pins, kPin, shields, kShield, sizes.pin_and_shield()),
                          nearest(shields, kShield, shields, kShield, sizes.shield_and_shield())})
    if (gap) gaps.push_back(*gap);
  return gaps;
}

std::optional<MagnetError> check_fit(const Arrangement& arrangement, const ArraySizes& sizes) {
  if (auto problem = problem_with(sizes)) return MagnetError{*problem, GeometryPart::kAllSizes};
  std::optional<MagnetGap> worst;
  for (const MagnetGap& gap : smallest_gaps(arrangement, sizes))
    if (gap.gap_mm <= 0.0 && (!worst || gap.gap_mm < worst->gap_mm)) worst = gap;
  if (!worst) return std::nullopt;
  return MagnetError{
      fmt::format("{} {} and {} {} overlap by {:.2f} mm at {:.2f} degrees", name_of(worst->kind_a),
                  worst->id_a, name_of(worst->kind_b), worst->id_b, -worst->gap_mm,
                  worst->angle_deg),
      worst->kind_b == MagnetKind::kPin ? GeometryPart::kPinSizes : GeometryPart::kAllSizes};
}

double magnets_mass_g(const Arrangement& arrangement, const ArraySizes& sizes) noexcept {
  return static_cast<double>(arrangement.pins.size()) * mass_g(sizes.pin) +
         static_cast<double>(arrangement.shields.size()) * mass_g(sizes.shield);
}

}  // namespace hedgehog::model
