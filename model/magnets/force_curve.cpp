// SPDX-License-Identifier: MIT
#include "model/magnets/force_curve.h"

#include <algorithm>
#include <cmath>

#include "model/magnets/pair/face_flux.h"

namespace hedgehog::model {
namespace {

/// The end faces that a pin brings to the points of a grid. Where the height is a multiple of the
/// step, many a lower face comes to where an upper one was.
struct Faces {
  std::vector<double> distance_mm;
  /// For each offset the places in `distance_mm`.
  std::vector<std::size_t> bottom;
  std::vector<std::size_t> top;
};

Faces faces_of(const std::vector<double>& offsets_mm, const ArraySizes& sizes) {
  constexpr double kSameMm = 1e-9;
  Faces faces;
  const auto index_of = [&](double distance_mm) {
    const auto same = [&](double known) { return std::abs(known - distance_mm) < kSameMm; };
    const auto found = std::find_if(faces.distance_mm.begin(), faces.distance_mm.end(), same);
    const auto index = static_cast<std::size_t>(found - faces.distance_mm.begin());
    if (found == faces.distance_mm.end()) faces.distance_mm.push_back(distance_mm);
    return index;
  };
  for (const double offset : offsets_mm) {
    faces.bottom.push_back(index_of(sizes.sphere_radius_mm + offset));
    faces.top.push_back(index_of(sizes.sphere_radius_mm + offset + sizes.pin.height_mm));
  }
  return faces;
}

/// Adds what magnets under these angles do; `sign` -1: of opposite polarity.
void add_exact(const MagnetPair& pair, const AngleCount& angle, double sign, double accuracy,
               const Faces& faces, ForceCurve& curve) {
  const FaceFlux flux(pair, angle.angle_deg, 0.0);
  std::vector<FaceForce> known(faces.distance_mm.size());
  const auto face = [&](std::size_t at) -> FaceForce& {
    if (known[at].order == 0) known[at] = flux.first(faces.distance_mm[at], accuracy);
    return known[at];
  };
  for (std::size_t i = 0; i < curve.offsets_mm.size(); ++i) {
    const std::size_t bottom = faces.bottom[i];
    const std::size_t top = faces.top[i];
    const PairForce force = settle(flux, faces.distance_mm[bottom], face(bottom),
                                   faces.distance_mm[top], face(top), accuracy);
    curve.force_n[i] += sign * angle.count * force.force_n;
    curve.error_n[i] += angle.count * force.error_n;
  }
}

void add(const MagnetPair& pair, const std::vector<AngleCount>& angles, double sign,
         const ForceSettings& settings, const Faces& faces, ForceCurve& curve) {
  for (const AngleCount& angle : angles) {
    if (!takes_dipoles(settings.model, angle.angle_deg)) {
      add_exact(pair, angle, sign, clamped(settings.accuracy), faces, curve);
      continue;
    }
    for (std::size_t i = 0; i < curve.offsets_mm.size(); ++i) {
      const PairPlace place{angle.angle_deg, curve.offsets_mm[i], 0.0};
      curve.force_n[i] += sign * angle.count * pair_force(pair, place, settings).force_n;
    }
  }
}

}  // namespace

PairForce PinForce::at(double offset_mm) const noexcept {
  PairForce sum;
  const auto add = [&](const MagnetPair& pair, const std::vector<AngleCount>& angles, double sign) {
    for (const AngleCount& angle : angles) {
      const PairForce force = pair_force(pair, {angle.angle_deg, offset_mm, 0.0}, settings_);
      sum.force_n += sign * angle.count * force.force_n;
      sum.error_n += angle.count * force.error_n;
    }
  };
  add(sizes_.pin_and_pin(), class_->to_pins, 1.0);
  add(sizes_.pin_and_shield(), class_->to_shields, -1.0);
  return sum;
}

std::vector<double> OffsetGrid::offsets_mm() const {
  std::vector<double> offsets;
  // Half a step's ten-thousandth, so that rounding does not lose the last point.
  const double last = last_mm + 5e-5 * step_mm;
  for (int i = 0; first_mm + i * step_mm <= last; ++i) offsets.push_back(first_mm + i * step_mm);
  return offsets;
}

ForceCurve force_curve(const PinForce& force, const OffsetGrid& grid) {
  ForceCurve curve;
  curve.offsets_mm = grid.offsets_mm();
  curve.force_n.resize(curve.offsets_mm.size());
  curve.error_n.resize(curve.offsets_mm.size());
  const ArraySizes& sizes = force.sizes();
  const Faces faces = faces_of(curve.offsets_mm, sizes);
  add(sizes.pin_and_pin(), force.pin_class().to_pins, 1.0, force.settings(), faces, curve);
  add(sizes.pin_and_shield(), force.pin_class().to_shields, -1.0, force.settings(), faces, curve);
  return curve;
}

}  // namespace hedgehog::model
