// SPDX-License-Identifier: MIT
#include "model/magnets/force_curve.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "model/magnets/pair/face_flux.h"

namespace hedgehog::model {
namespace {

/// Positions of a pin's end faces at the points of a grid. If the height is a multiple of the step,
/// lower and upper faces share positions.
struct Faces {
  std::vector<double> distance_mm;
  /// For each offset the index in `distance_mm`.
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

/// Force curve of one magnet at that angle.
ForceCurve exact_pair_curve(const MagnetPair& pair, double angle_deg, double accuracy,
                            const Faces& faces) {
  const FaceFlux flux(pair, angle_deg, 0.0);
  std::vector<FaceForce> known(faces.distance_mm.size());
  const auto face = [&](std::size_t at) -> FaceForce& {
    if (known[at].order == 0) known[at] = flux.first(faces.distance_mm[at], accuracy);
    return known[at];
  };
  ForceCurve curve;
  for (std::size_t i = 0; i < faces.bottom.size(); ++i) {
    const std::size_t bottom = faces.bottom[i];
    const std::size_t top = faces.top[i];
    const PairForce force = settle(flux, faces.distance_mm[bottom], face(bottom),
                                   faces.distance_mm[top], face(top), accuracy);
    curve.force_n.push_back(force.force_n);
    curve.error_n.push_back(force.error_n);
  }
  return curve;
}

ForceCurve pair_curve(const MagnetPair& pair, double angle_deg, const ForceSettings& settings,
                      const std::vector<double>& offsets_mm, const Faces& faces) {
  if (!takes_dipoles(settings.model, angle_deg))
    return exact_pair_curve(pair, angle_deg, clamped(settings.accuracy), faces);
  ForceCurve curve;
  for (const double offset_mm : offsets_mm) {
    curve.force_n.push_back(pair_force(pair, {angle_deg, offset_mm, 0.0}, settings).force_n);
    curve.error_n.push_back(0.0);
  }
  return curve;
}

/// Adds `factor` times the force of one magnet; `factor` below 0: of opposite polarity.
void add(const ForceCurve& pair, double factor, ForceCurve& sum) {
  for (std::size_t i = 0; i < sum.offsets_mm.size(); ++i) {
    sum.force_n[i] += factor * pair.force_n[i];
    sum.error_n[i] += std::abs(factor) * pair.error_n[i];
  }
}

ForceCurve empty_curve(const OffsetGrid& grid) {
  ForceCurve curve;
  curve.offsets_mm = grid.offsets_mm();
  curve.force_n.resize(curve.offsets_mm.size());
  curve.error_n.resize(curve.offsets_mm.size());
  return curve;
}

/// Curves of one kind of pair, each computed at the first use of its angle.
class PairCurves {
 public:
  PairCurves(const MagnetPair& pair, const ForceSettings& settings, const Faces& faces,
             const std::vector<double>& offsets_mm)
      : pair_(pair), settings_(settings), faces_(faces), offsets_mm_(offsets_mm) {}

  void add_to(ForceCurve& sum, const std::vector<AngleCount>& angles, double sign) {
    for (const AngleCount& angle : angles) add(at(angle.angle_deg), sign * angle.count, sum);
  }

 private:
  const ForceCurve& at(double angle_deg) {
    const auto [known, is_new] = curves_.try_emplace(std::lround(angle_deg / kSameAngleDeg));
    if (is_new) known->second = pair_curve(pair_, angle_deg, settings_, offsets_mm_, faces_);
    return known->second;
  }

  MagnetPair pair_;
  ForceSettings settings_;
  const Faces& faces_;
  const std::vector<double>& offsets_mm_;
  std::unordered_map<long, ForceCurve> curves_;
};

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
  // Tolerance, so that rounding does not drop the last point.
  const double last = last_mm + 5e-5 * step_mm;
  for (int i = 0; first_mm + i * step_mm <= last; ++i) offsets.push_back(first_mm + i * step_mm);
  return offsets;
}

ForceCurve force_curve(const PinForce& force, const OffsetGrid& grid) {
  ForceCurve curve = empty_curve(grid);
  const ArraySizes& sizes = force.sizes();
  const Faces faces = faces_of(curve.offsets_mm, sizes);
  const auto add_all = [&](const MagnetPair& pair, const std::vector<AngleCount>& angles,
                           double sign) {
    for (const AngleCount& angle : angles)
      add(pair_curve(pair, angle.angle_deg, force.settings(), curve.offsets_mm, faces),
          sign * angle.count, curve);
  };
  add_all(sizes.pin_and_pin(), force.pin_class().to_pins, 1.0);
  add_all(sizes.pin_and_shield(), force.pin_class().to_shields, -1.0);
  return curve;
}

std::vector<ForceCurve> force_curves(const std::vector<PinClass>& classes, const ArraySizes& sizes,
                                     const ForceSettings& settings, const OffsetGrid& grid) {
  const std::vector<double> offsets_mm = grid.offsets_mm();
  const Faces faces = faces_of(offsets_mm, sizes);
  PairCurves pins(sizes.pin_and_pin(), settings, faces, offsets_mm);
  PairCurves shields(sizes.pin_and_shield(), settings, faces, offsets_mm);
  std::vector<ForceCurve> curves;
  for (const PinClass& pin_class : classes) {
    ForceCurve curve = empty_curve(grid);
    pins.add_to(curve, pin_class.to_pins, 1.0);
    shields.add_to(curve, pin_class.to_shields, -1.0);
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace hedgehog::model
