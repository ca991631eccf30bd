// SPDX-License-Identifier: MIT
#include "model/magnets/electromagnet.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/magnets/ball_geometry.h"

namespace hedgehog::model {

double force_per_moment_n(const CylinderMagnet& pin, double sphere_radius_mm,
                          double offset_mm) noexcept {
  const PinMagnet rod{pin.remanence_t, 1e-3 * pin.radius_mm(), 1e-3 * pin.height_mm,
                      1e-3 * sphere_radius_mm};
  return force_per_moment(rod, 1e-3 * offset_mm);
}

Electromagnet fea_electromagnet() noexcept {
  return {kFeaCalibration.name, 0.4 / kBurstCurrentA / force_per_moment(kThesisPin)};
}

Electromagnet measured_electromagnet() {
  const double rest_m = 1e-3 * thesis_ball().curves.typical_rest_mm();
  return {kMeasuredCalibration.name,
          kMeasuredCalibration.force_slope_n_a / force_per_moment(kThesisPin, rest_m)};
}

double coil_force_n(const Electromagnet& coil, double current_a, const CylinderMagnet& pin,
                    double sphere_radius_mm, double angle_deg, double offset_mm) noexcept {
  return coil.moment_per_ampere * current_a * force_per_moment_n(pin, sphere_radius_mm, offset_mm) *
         std::cos(angle_deg * std::numbers::pi / 180.0);
}

std::vector<Activation> activation_spread(const Arrangement& arrangement, int aimed) {
  Vec3 field{0, 0, 1};
  for (const MagnetSite& pin : arrangement.pins)
    if (pin.id == aimed) field = pin.direction;
  std::vector<Activation> spread;
  for (const MagnetSite& pin : arrangement.pins)
    spread.push_back({pin.id, angle_deg(field, pin.direction), dot(field, pin.direction)});
  std::stable_sort(spread.begin(), spread.end(), [](const Activation& a, const Activation& b) {
    return a.fraction > b.fraction;
  });
  return spread;
}

}  // namespace hedgehog::model
