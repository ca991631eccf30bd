// SPDX-License-Identifier: MIT
// True state of the simulated ball (`sim.truth`), independent of its electronics.
#pragma once

#include <array>

#include "model/coils.h"
#include "model/vec3.h"

namespace hedgehog::device {

/// Trivially copyable.
struct PlantTruth {
  /// False until the simulated board has sent it.
  bool known = false;
  std::array<double, model::kCoils> coils_c{};
  double core_c = 0.0;
  double skin_c = 0.0;
  double ambient_c = 0.0;
  model::Vec3 current_a;
};

}  // namespace hedgehog::device
