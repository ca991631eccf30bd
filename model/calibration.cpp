// SPDX-License-Identifier: MIT
#include "model/calibration.h"

#include <cmath>

namespace hedgehog::model {

double force_per_moment(const PinMagnet& pin, double extension_m) noexcept {
  const double a2 = pin.radius_m * pin.radius_m;
  const double z1 = pin.inner_face_m + extension_m;
  const double z2 = z1 + pin.length_m;
  return 0.5 * pin.remanence_t * a2 * (std::pow(a2 + z1 * z1, -1.5) - std::pow(a2 + z2 * z2, -1.5));
}

}  // namespace hedgehog::model
