// SPDX-License-Identifier: MIT
#include "model/magnets/pair/face_flux.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/magnets/pair/disk_rule.h"
#include "model/units.h"

namespace hedgehog::model {
namespace {

/// Rounding error relative to the force on the face without cancellation.
constexpr double kRounding = 1e-14;
/// Maximum ratio of the radius of a face to its distance from a rim; the theory is valid below 1.
constexpr double kNearestRatio = 0.99;

/// Decades of error removed by one more order. The other's field, continued, is analytic up to its
/// rims, at 1/q of the face's radius from the middle of the face, and a rule of order n is exact
/// below degree 4n: at least q^4. The second term is empirical, from 4000 random pairs.
double decades_per_order(double q) noexcept { return -4.0 * std::log10(q) + 0.4; }

}  // namespace

FaceFlux::FaceFlux(const MagnetPair& pair, double angle_deg, double other_offset_mm) noexcept
    : other_(pair.other),
      radius_mm_(pair.subject.radius_mm()),
      sine_(std::sin(angle_deg * kRadiansPerDegree)),
      cosine_(std::cos(angle_deg * kRadiansPerDegree)),
      other_middle_mm_(pair.sphere_radius_mm + other_offset_mm + 0.5 * pair.other.height_mm),
      newton_per_tesla_(pair.subject.remanence_t / kVacuumPermeability * std::numbers::pi *
                        radius_mm_ * radius_mm_ * 1e-6) {}

/// Field along the subject's axis; `across` is in the plane of both axes.
double FaceFlux::axial_field(double across_mm, double beside_mm,
                             double distance_mm) const noexcept {
  const double x = distance_mm * sine_ + across_mm * cosine_;
  const double z = distance_mm * cosine_ - across_mm * sine_ - other_middle_mm_;
  const double rho = std::sqrt(x * x + beside_mm * beside_mm);
  const AxialField field = field_of(other_, rho, z);
  const double radial = rho > 0.0 ? field.radial_t * x / rho : 0.0;
  return radial * sine_ + field.axial_t * cosine_;
}

FaceFlux::Integral FaceFlux::integral(double distance_mm, int order) const noexcept {
  if (order == 0) {
    const double force_n = newton_per_tesla_ * axial_field(0.0, 0.0, distance_mm);
    return {force_n, std::abs(force_n)};
  }
  const DiskRule& rule = disk_rule(order);
  const auto radii = static_cast<std::size_t>(order);
  double sum = 0.0;
  double gross = 0.0;
  for (std::size_t i = 0; i < radii; ++i) {
    const double radius = radius_mm_ * rule.radius[i];
    double ring = 0.0;
    double ring_gross = 0.0;
    for (std::size_t j = 0; j < 2 * radii; ++j) {
      const double field = axial_field(radius * rule.cosine[j], radius * rule.sine[j], distance_mm);
      ring += field;
      ring_gross += std::abs(field);
    }
    sum += rule.weight[i] * ring;
    gross += rule.weight[i] * ring_gross;
  }
  const double scale = newton_per_tesla_ / (2 * order);
  return {scale * sum, scale * gross};
}

/// Ratio of the face's radius to the distance from its middle to the nearest rim of the other.
double FaceFlux::rim_ratio(double distance_mm) const noexcept {
  const double x = std::abs(distance_mm * sine_);
  const double z = std::abs(distance_mm * cosine_ - other_middle_mm_);
  const double to_rim = std::hypot(x - other_.radius_mm(), z - 0.5 * other_.height_mm);
  return std::min(radius_mm_ / to_rim, kNearestRatio);
}

FaceForce FaceFlux::compared(double distance_mm, int order, double coarse_n,
                             int coarse_order) const noexcept {
  const Integral fine = integral(distance_mm, order);
  const double q = rim_ratio(distance_mm);
  // Ten times the theoretical error; bounded the error in 400 000 random pairs. The theory does not
  // apply with the face above the other magnet, i.e. the rim below and not beside it.
  const double caution = q < kNearestRatio ? 10.0 : 100.0;
  // The midpoint alone is exact below degree 2 only, i.e. half an order.
  const double steps = order - std::max(0.5, static_cast<double>(coarse_order));
  const double gain = caution * std::min(1.0, std::pow(q, 4.0 * steps));
  // Two orders may agree by chance: the typical error is a lower bound.
  const double usual = 0.4 * caution * std::pow(10.0, -order * decades_per_order(q));
  return {fine.force_n,
          gain * std::abs(fine.force_n - coarse_n) + (usual + kRounding) * fine.gross_n, order};
}

FaceForce FaceFlux::first(double distance_mm, double accuracy) const noexcept {
  const double decades = 0.5 - std::log10(accuracy);
  const double likely = std::ceil(decades / decades_per_order(rim_ratio(distance_mm)));
  const int order = std::clamp(static_cast<int>(likely), 1, DiskRule::kMaxOrder);
  return compared(distance_mm, order, integral(distance_mm, order - 1).force_n, order - 1);
}

FaceForce FaceFlux::refined(double distance_mm, const FaceForce& known,
                            double tolerance_n) const noexcept {
  const double decades = std::log10(known.error_n / tolerance_n);
  const double more = std::ceil(decades / decades_per_order(rim_ratio(distance_mm)));
  const int order =
      std::min(known.order + std::clamp(static_cast<int>(more), 1, 6), DiskRule::kMaxOrder);
  return compared(distance_mm, order, known.force_n, known.order);
}

PairForce settle(const FaceFlux& flux, double bottom_mm, FaceForce& bottom, double top_mm,
                 FaceForce& top, double accuracy) noexcept {
  // Near a zero of the force the accuracy is relative to one face.
  constexpr double kOfOneFace = 1e-4;
  while (true) {
    const double force_n = top.force_n - bottom.force_n;
    const double error_n = top.error_n + bottom.error_n;
    const double larger_n = std::max(std::abs(top.force_n), std::abs(bottom.force_n));
    const double tolerance_n = accuracy * std::max(std::abs(force_n), kOfOneFace * larger_n);
    const bool top_is_worse = top.error_n > bottom.error_n;
    FaceForce& worse = top_is_worse ? top : bottom;
    if (error_n <= tolerance_n || worse.order >= DiskRule::kMaxOrder ||
        worse.error_n <= 2.0 * kRounding * larger_n)
      return {force_n, error_n};
    worse = flux.refined(top_is_worse ? top_mm : bottom_mm, worse, 0.5 * tolerance_n);
  }
}

}  // namespace hedgehog::model
